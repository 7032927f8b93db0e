"""What is written in Rust."""

from collections.abc import Iterator, Mapping, Sequence
from os import PathLike
from typing import Any, ClassVar, Final, Unpack, final

import numpy as np
import numpy.typing as npt

from schuler.types import (
    Array,
    EnsembleOptions,
    Increments,
    NavigatorOptions,
    Options,
    ReplayOptions,
    SceneLike,
    StateLike,
)

__all__ = [
    "Aided",
    "AidedEnsemble",
    "Aligned",
    "Allan",
    "Emulation",
    "Ensemble",
    "Flight",
    "Navigator",
    "Replay",
    "Scene",
    "State",
    "Steps",
    "Table",
    "Trajectory",
    "__version__",
    "aided_ensemble",
    "align",
    "allan",
    "datasheet",
    "emulate",
    "ensemble",
    "navigators",
    "replay",
    "run",
    "scene_text",
    "scenes",
    "steps",
]

__version__: Final[str]

def scenes() -> dict[str, str]:
    """Every built-in scene with a line about it."""

def scene_text(name: str) -> str:
    """The TOML text of a built-in scene, to start from."""

def navigators() -> list[str]:
    """The names of all navigators, as `Navigator` takes them."""

def run(
    scene: SceneLike | None = None,
    *,
    rows: bool = True,
    every: int | str | None = None,
    force_all: bool = False,
    run: int = 0,
    **options: Unpack[Options],
) -> Flight:
    """Flies a scene (that of the paper unless told), and compares its navigation with truth and theory.

    `every` keeps each so many rows, or a row each so many seconds ("10s"); the extremes are over all. `run` is the
    number of an ensemble's run that is flown by itself. A flight that
    cannot go on raises FlightError, whose `flown` is what was flown.
    """

def emulate(
    scene: SceneLike | None = None,
    *,
    perfect: bool = False,
    rates: bool = False,
    run: int = 0,
    **options: Unpack[Options],
) -> Emulation:
    """The sensors' samples of a scene, with the truth and the state to start from.

    `perfect` leaves the sensors' errors out; `rates` gives instantaneous rates in place of increments.
    """

def replay(
    imu: str | PathLike[str] | Table | npt.ArrayLike,
    initial: StateLike | None = None,
    **options: Unpack[ReplayOptions],
) -> Replay:
    """Navigates a recording: a log of any format that the program reads, the `imu` of an emulation, or an array of
    seven columns, time_s and increments. Warnings of the program are warnings of Python.

    With `gnss` it is aided: `nav` then has a row at each end of a block, with the filter's standard deviations.
    """

def ensemble(
    scene: SceneLike | None = None,
    runs: int | None = None,
    *,
    at: int | str | Sequence[float] | npt.NDArray[np.float64] | None = None,
    budget: int | None = None,
    threads: int | None = None,
    **options: Unpack[EnsembleOptions],
) -> Ensemble:
    """Flies many runs of a scene (64 unless told), on all processors unless told; a run depends on its number and the
    seed alone. `at` is a number of times or times in seconds, `budget` flies so many runs without each error term. A
    scene that is aided is for `aided_ensemble`."""

def aided_ensemble(
    scene: SceneLike | None = None,
    runs: int | None = None,
    *,
    at: int | str | Sequence[float] | npt.NDArray[np.float64] | None = None,
    budget: int | None = None,
    threads: int | None = None,
    **options: Unpack[EnsembleOptions],
) -> AidedEnsemble:
    """The same of a scene that is aided, whose runs are held against what their filters say."""

def align(
    increments: Increments,
    rate: float,
    initial: StateLike,
    *,
    heading: float | None = None,
    coarse: bool = False,
) -> Aligned:
    """Finds level, north and biases from samples at rest, at the position of a state, by a filter; level and north by
    the means alone where `coarse` says so, or `heading` is one that is known, degrees."""

def steps(
    initial: StateLike,
    rate: float,
    increments: Increments,
    *,
    name: str | None = None,
    **options: Unpack[NavigatorOptions],
) -> Steps:
    """Flies samples from a state with one of the audited navigators, and shows every step in bits."""

def allan(
    scene: SceneLike | None = None,
    *,
    imu: str | PathLike[str] | Table | npt.ArrayLike | None = None,
    span: tuple[float, float] | Sequence[float] | None = None,
    units: str | None = None,
    **options: Unpack[Options],
) -> Allan:
    """Measures the Allan deviation of a scene's sensor errors, or of a recording at rest (`imu`, or its `span` in s), and
    finds the error terms. A scene beside a recording is what that is compared with."""

def datasheet(sheet: str | PathLike[str] | Mapping[str, Any]) -> dict[str, Any]:
    """The sections `gyro` and `accelerometer` of a scene for a data sheet: a TOML file, its text, or a dict with its keys."""

@final
class Scene:
    """A scene that has been read and checked."""

    def __new__(cls, source: SceneLike | None = None, **options: Unpack[Options]) -> Scene: ...
    @property
    def name(self) -> str:
        """The built-in name, or the file's stem."""
    @property
    def title(self) -> str:
        """One line about it."""
    @property
    def sha256(self) -> str:
        """Of the text that it was read from."""
    @property
    def duration_s(self) -> float:
        """Length, s."""
    @property
    def rate_hz(self) -> float:
        """Samples per second."""
    @property
    def seed(self) -> int:
        """Of everything random."""
    @property
    def samples(self) -> int:
        """How many there are."""

@final
class Table:
    """Numbers in rows, their columns by name. Every column is a view of one array."""

    @property
    def columns(self) -> tuple[str, ...]:
        """Their names."""
    @property
    def array(self) -> Array:
        """All numbers, a row each: not a copy."""
    def keys(self) -> tuple[str, ...]:
        """The names of the columns, so that `dict(table)` has them all."""
    def frame(self) -> Any:
        """A pandas DataFrame of the same numbers."""
    def __getitem__(self, name: str, /) -> Array: ...
    def __contains__(self, name: str, /) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def __array__(self, dtype: npt.DTypeLike | None = None, copy: bool | None = None) -> npt.NDArray[Any]: ...
    def _repr_html_(self) -> str: ...

@final
class State:
    """A time, a position, a velocity and an attitude, in the units of `nav.csv`; a start keeps twice the digits."""

    def __new__(
        cls,
        *,
        latitude_deg: float,
        longitude_deg: float,
        altitude_m: float = 0.0,
        north_m_s: float = 0.0,
        east_m_s: float = 0.0,
        down_m_s: float = 0.0,
        roll_deg: float = 0.0,
        pitch_deg: float = 0.0,
        yaw_deg: float = 0.0,
        time_s: float = 0.0,
    ) -> State: ...
    @staticmethod
    def read(path: str | PathLike[str]) -> State:
        """From an `initial.toml`."""
    def toml(self) -> str:
        """The text of an `initial.toml`."""
    def as_dict(self) -> dict[str, float]:
        """The numbers by their names."""
    @property
    def time_s(self) -> float: ...
    @property
    def latitude_deg(self) -> float: ...
    @property
    def longitude_deg(self) -> float: ...
    @property
    def altitude_m(self) -> float:
        """Above the ellipsoid."""
    @property
    def north_m_s(self) -> float: ...
    @property
    def east_m_s(self) -> float: ...
    @property
    def down_m_s(self) -> float: ...
    @property
    def roll_deg(self) -> float: ...
    @property
    def pitch_deg(self) -> float: ...
    @property
    def yaw_deg(self) -> float: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...
    __hash__: ClassVar[None]  # type: ignore[assignment]

@final
class Flight:
    """A flight of `run`. In a notebook it shows its report."""

    @property
    def scene(self) -> Scene:
        """As flown."""
    @property
    def digest(self) -> str:
        """Of every state: flights with the same one have the same bits."""
    @property
    def samples(self) -> int:
        """Samples navigated."""
    @property
    def window(self) -> tuple[int, int, int] | None:
        """Samples of history, block, look-ahead; None for textbook."""
    @property
    def ended(self) -> str | None:
        """Why it ended early, if it did."""
    @property
    def drift(self) -> Table:
        """Computed less true, what theory expects of it (`_mean`) and its standard deviation (`_sigma`): that of the
        filter where the scene is aided."""
    @property
    def nav(self) -> Table:
        """The computed motion: `nav.csv`."""
    @property
    def truth(self) -> Table:
        """The true motion: `truth.csv`."""
    @property
    def aided(self) -> Aided | None:
        """What became of the measurements; None of a scene that has none."""
    @property
    def summary(self) -> dict[str, Any]:
        """`summary.json`, without the command line and the files."""
    def report(self) -> str:
        """`report.html`."""
    def picture(self) -> bytes:
        """`drift.png`."""
    def _repr_html_(self) -> str: ...

@final
class Emulation:
    """Samples of `emulate`."""

    @property
    def scene(self) -> Scene:
        """As emulated."""
    @property
    def imu(self) -> Table:
        """A row for each sample that arrives: `imu.csv`."""
    @property
    def truth(self) -> Table:
        """The start and a row for each sample: `truth.csv`."""
    @property
    def gnss(self) -> dict[str, Table]:
        """What the scene's aiding sensors deliver, in the order of arrival, by what it measures ("position-velocity"):
        the rows of `gnss.csv`. Empty of a scene without such sensors."""
    @property
    def initial(self) -> State:
        """Where navigation starts, off by the scene's initial error: `initial.toml`."""
    @property
    def lost(self) -> int:
        """Samples lost on the link."""

@final
class Replay:
    """A recording that was navigated. In a notebook it shows its report, where there is a reference."""

    @property
    def nav(self) -> Table:
        """A row for each sample, or with `gnss` for each block: `nav.csv`."""
    @property
    def aided(self) -> Aided | None:
        """What became of the measurements; None without `gnss`."""
    @property
    def start(self) -> State:
        """As given, or as aligned."""
    @property
    def digest(self) -> str:
        """Of every state."""
    @property
    def window(self) -> tuple[int, int, int] | None:
        """Samples of history, block, look-ahead; None for textbook."""
    @property
    def summary(self) -> dict[str, Any] | None:
        """`summary.json`; None without a reference."""
    def report(self) -> str | None:
        """`report.html`; None without a reference."""
    def _repr_html_(self) -> str: ...

@final
class Aided:
    """What became of the measurements of an aided flight, and what its filter found."""

    @property
    def judged(self) -> dict[str, Table]:
        """Verdicts by what was measured, as in `gnss.csv` ("position-velocity", "height"), in the order in which they
        were made: when it was true and how old it was then, `nis` = Σ y²/α of `degrees` components, the `limit` above
        which it is refused (1e30 while the heading is looked for), and 1 or 0 for `accepted` and `locked_out`: the
        last of so many refusals that the filter doubts itself."""
    @property
    def estimates(self) -> Table:
        """Biases of the sensors beyond what an alignment found (x, y, z: forward, right, down) and further states of
        the filter, then the standard deviation of each (`_sigma`): a row for each of `nav`; the last alone where no
        rows are kept."""
    @property
    def smoothed(self) -> Table | None:
        """The states in the light of all measurements, since the filter last started, with standard deviations; None
        unless that is asked for (`smooth`, or `filter.smoother` of a scene)."""
    @property
    def withheld(self) -> Table | None:
        """How far off the navigator was at the last position of each span of `withhold`, what the filter and the fix
        say of that together, and `nees` = eᵀP⁻¹e of three components."""
    @property
    def summary(self) -> dict[str, Any]:
        """Counts by sensor with Σ NIS, measurements that came again, too late or found no room, when it locked out or
        started again, and of smoothed states their errors where the truth is known."""

@final
class Ensemble:
    """Many runs beside theory; in a notebook they show their page. Arrays have a row for each instant, and in it the nine numbers of `names`."""

    @property
    def scene(self) -> Scene:
        """As flown."""
    @property
    def runs(self) -> int:
        """Runs that were flown."""
    @property
    def names(self) -> list[str]:
        """Of the nine numbers: position, velocity, attitude."""
    @property
    def time_s(self) -> Array:
        """Of the instants."""
    @property
    def drift(self) -> Array:
        """Instant, run, number: computed less true, of the runs that reached their end."""
    @property
    def mean(self) -> Array:
        """Over the runs."""
    @property
    def sigma(self) -> Array:
        """Over the runs."""
    @property
    def mean_theory(self) -> Array:
        """What theory expects; not a number where it has ended."""
    @property
    def sigma_theory(self) -> Array:
        """What theory expects; not a number where it has ended."""
    @property
    def failed(self) -> list[tuple[int, int, str]]:
        """Number, sample and reason of each run that did not reach its end."""
    @property
    def tests(self) -> tuple[int, int]:
        """Tests against theory: how many, and how many fail."""
    @property
    def covariance(self) -> Array:
        """Instant, number, number: over the runs; m, m/s, arcsec."""
    @property
    def covariance_theory(self) -> Array:
        """What theory expects; not a number where it has ended."""
    @property
    def accuracy(self) -> Table:
        """CEP of 50 % and 95 % and the vertical error of 95 %, of the runs and by theory: `accuracy.csv`."""
    @property
    def verdict(self) -> list[str]:
        """What parts from theory, in sentences."""
    @property
    def summary(self) -> dict[str, Any]:
        """`ensemble.json`, without the command line and the files."""
    @property
    def text(self) -> str:
        """What the program prints."""
    def report(self) -> str:
        """`ensemble.html`."""
    def _repr_html_(self) -> str: ...

@final
class AidedEnsemble:
    """Aided runs beside what their filters say; in a notebook they show their page. Arrays have a row for each instant."""

    @property
    def scene(self) -> Scene:
        """As flown."""
    @property
    def runs(self) -> int:
        """Runs that were flown."""
    @property
    def names(self) -> list[str]:
        """Of the nine numbers: position, velocity, attitude."""
    @property
    def groups(self) -> list[str]:
        """Of those of the nine that NEES is told of: all, position, velocity, attitude."""
    @property
    def time_s(self) -> Array:
        """Of the instants."""
    @property
    def drift(self) -> Array:
        """Instant, run, number: computed less true, of the runs that reached their end."""
    @property
    def rms(self) -> Array:
        """Instant, number: root of the mean square over the runs."""
    @property
    def sigma(self) -> Array:
        """Instant, number: root of the mean variance that the filters say."""
    @property
    def nees(self) -> Array:
        """Instant, group: the mean of eᵀP⁻¹e over the runs, by its degrees of freedom: 1 is expected."""
    @property
    def nees_expected(self) -> Array:
        """Instant, group, two: where 95 % of such means lie."""
    @property
    def smoothed(self) -> dict[str, Array] | None:
        """`time_s`, `rms`, `sigma`, `nees` and `nees_expected` of smoothed runs, at the instants that smoothers reach;
        None unless the scene asks for a smoother."""
    @property
    def failed(self) -> list[tuple[int, int, str]]:
        """Number, sample and reason of each run that did not reach its end."""
    @property
    def tests(self) -> tuple[int, int]:
        """Tests of NEES: how many, and how many fail."""
    @property
    def verdict(self) -> list[str]:
        """How errors part from what the filters say, in sentences."""
    @property
    def summary(self) -> dict[str, Any]:
        """`ensemble.json`, without the command line and the files."""
    @property
    def text(self) -> str:
        """What the program prints."""
    def report(self) -> str:
        """`ensemble.html`."""
    def _repr_html_(self) -> str: ...

@final
class Allan:
    """What a sensor is made of. In a notebook it shows its page."""

    @property
    def axes(self) -> dict[str, Table]:
        """Of each axis that shows something ("gyro x"): averaging time, deviation with its 95 % interval, what is fitted
        and what is configured, in rad/s and m/s²."""
    @property
    def sections(self) -> dict[str, Any]:
        """The sections of a scene that stand for the sensor."""
    @property
    def text(self) -> str:
        """What the program prints."""
    def report(self) -> str:
        """`allan.html`."""
    def _repr_html_(self) -> str: ...

@final
class Aligned:
    """An attitude that was found at rest."""

    @property
    def state(self) -> State:
        """At rest, where it was said to be."""
    @property
    def level_sigma_deg(self) -> float:
        """Standard deviation of level."""
    @property
    def heading_sigma_deg(self) -> float | None:
        """Standard deviation of the heading; None where that was given."""
    @property
    def gyro_bias_deg_h(self) -> list[float] | None:
        """Biases of the gyros; None of the means alone."""
    @property
    def gyro_bias_sigma_deg_h(self) -> list[float] | None:
        """Their standard deviations."""
    @property
    def accelerometer_bias_ug(self) -> list[float] | None:
        """Biases of the accelerometers; None of the means alone."""
    @property
    def accelerometer_bias_sigma_ug(self) -> list[float] | None:
        """Their standard deviations."""
    @property
    def text(self) -> str:
        """What the program prints."""

@final
class Trajectory:
    """A motion: that of a scene, or of the keys of `[trajectory]` in a dict (channels, segments, way-points, a log in
    arrays or a file), whose rate and duration are options."""

    def __new__(
        cls, source: SceneLike | Mapping[str, Any] | None = None, **options: Unpack[Options]
    ) -> Trajectory: ...
    @property
    def scene(self) -> Scene:
        """The scene that flies it."""
    @property
    def duration_s(self) -> float:
        """Length, s."""
    def state(self, time_s: float) -> State:
        """The state at a time, to start a navigator from."""
    def at(self, times_s: npt.ArrayLike) -> Table:
        """Position, velocity and attitude at some times."""
    def rates(self, times_s: npt.ArrayLike) -> Table:
        """What perfect sensors read at some times."""
    def extremes(self) -> dict[str, Any]:
        """Its length, and the least and the greatest of speed, climb, altitude, load, attitude and rates."""

@final
class Navigator:
    """A navigator step by step: one of `navigators()` by its name, or by options as a scene has them.

    It may be used from several threads, one after the other.
    """

    def __new__(
        cls,
        initial: StateLike,
        rate: float,
        *,
        name: str | None = None,
        **options: Unpack[NavigatorOptions],
    ) -> Navigator: ...
    @property
    def name(self) -> str:
        """Its name in the catalogue."""
    @property
    def rate_hz(self) -> float:
        """Samples per second, unless a sample has its own interval."""
    @property
    def state(self) -> State:
        """Navigation at the end of the last block."""
    @property
    def taken(self) -> int:
        """Samples taken so far."""
    @property
    def integrated(self) -> int:
        """Samples integrated so far: whole blocks of those taken."""
    @property
    def digest(self) -> str:
        """Of every state so far."""
    def push(
        self,
        angle_rad: Sequence[float] | npt.NDArray[np.float64],
        velocity_m_s: Sequence[float] | npt.NDArray[np.float64],
        interval_s: float | None = None,
    ) -> list[State]:
        """Takes a sample, ∫ω dt and ∫f dt over it; the rows that it completes, up to a block's."""
    def fly(self, increments: Increments, interval_s: npt.ArrayLike | None = None) -> Table:
        """Takes samples in order, read where they lie; the rows that they complete. A sample that is refused raises
        FlightError, whose `flown` has the rows until then; the navigator is as it was before that sample."""
    def finish(self) -> list[State]:
        """Ends the stream; the rows that wait for samples."""
    def hold_vertical(self, altitude_m: float, down_m_s: float) -> None:
        """Sets height and vertical velocity at the end of the last block."""
    def correct(
        self,
        *,
        position_ned_m: Sequence[float] | npt.NDArray[np.float64] = ...,
        velocity_ned_m_s: Sequence[float] | npt.NDArray[np.float64] = ...,
        attitude_ned_rad: Sequence[float] | npt.NDArray[np.float64] = ...,
    ) -> None:
        """Corrects the state at the end of the last block: the corrected one less the present, the attitude as a
        rotation about north, east and down."""

@final
class Steps:
    """Steps of a navigator: what a chain of `schuler audit` has."""

    @property
    def name(self) -> str:
        """The navigator's."""
    @property
    def sample(self) -> npt.NDArray[np.uint64]:
        """How many samples are behind each step."""
    @property
    def body_fields(self) -> tuple[str, ...]:
        """Names of the words of `body`, in order."""
    @property
    def nav_fields(self) -> tuple[str, ...]:
        """Names of the words of `nav`, in order."""
    @property
    def body(self) -> npt.NDArray[np.uint64]:
        """The body's motion over each step: the bits of its numbers, a row each."""
    @property
    def nav(self) -> npt.NDArray[np.uint64]:
        """The state after each step: the bits of its numbers, a row each."""
    @property
    def body_digest(self) -> str:
        """Of all of `body`, as a chain has it."""
    @property
    def nav_digest(self) -> str:
        """Of all of `nav`, as a chain has it."""
