"""Types of arguments, for annotations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, TypedDict

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from schuler._schuler import Scene, State, Table

#: Numbers of double precision.
Array: TypeAlias = npt.NDArray[np.float64]
#: A built-in scene's name, the path of a TOML file, the text of one, a dict with its keys, or a scene.
SceneLike: TypeAlias = "str | PathLike[str] | Mapping[str, Any] | Scene"
#: A state, a dict with the keys of an `initial.toml`, or the path of one.
StateLike: TypeAlias = "State | Mapping[str, float] | str | PathLike[str]"
#: Increments: six columns (angles in rad, velocities in m/s; forward, right, down), or the `imu` of an emulation.
Increments: TypeAlias = "Table | npt.ArrayLike"
#: Columns of a `gnss.csv`: what is not a number is not there.
Columns: TypeAlias = "Table | Mapping[str, npt.ArrayLike]"
#: A receiver's file, columns of a `gnss.csv`, or such columns by what they measure, as an emulation has them.
Fixes: TypeAlias = "str | PathLike[str] | Columns | Mapping[str, Columns]"
#: Three counts, or as text "2,4,2" or "auto".
Window: TypeAlias = "str | tuple[int, int, int]"


class NavigatorOptions(TypedDict, total=False):
    """How to navigate."""

    #: Axes of the mechanization.
    frame: Literal["local-level", "earth-fixed"] | None
    #: Arithmetic of the navigator.
    precision: Literal["f64", "f32", "f32x2"] | None
    #: Integration method.
    algorithm: Literal["taylor", "textbook"] | None
    #: Samples of history, block, look-ahead.
    window: Window | None


class Handling(NavigatorOptions, total=False):
    """How to navigate, the vertical channel and missing samples."""

    #: The vertical channel.
    vertical: Literal["free", "held"] | None
    #: What a missing sample does.
    gap: Literal["error", "bridge"] | None


class EnsembleOptions(NavigatorOptions, total=False):
    """What replaces a scene's own values in all runs."""

    #: Seed of everything random.
    seed: int | None
    #: Length, s.
    duration: float | None
    #: Samples per second.
    rate: float | None
    #: The vertical channel.
    vertical: Literal["free", "held"] | None


class Options(Handling, total=False):
    """What replaces a scene's own values."""

    #: Seed of everything random.
    seed: int | None
    #: Length, s.
    duration: float | None
    #: Samples per second.
    rate: float | None


class ReplayOptions(Handling, total=False):
    """Options of `replay`, as the command line has them."""

    #: What the stream's columns hold: a TOML file, or the name of a known format.
    map: str | PathLike[str] | None
    #: Columns of time, gyros x, y, z and accelerometers x, y, z: names or numbers from 1.
    columns: str | list[str] | list[int] | None
    #: Where x, y and z of the unit point, as in "forward-left-up".
    axes: str | None
    #: What the stream's numbers are in, as in "g,deg/s,ms".
    units: str | list[str] | None
    #: What the motion really was: a file.
    reference: str | PathLike[str] | None
    #: How late the reference's stamps are, s, or "auto".
    lag: float | Literal["auto"] | None
    #: Skip to this time of the recording, s.
    start: float | None
    #: First stand still this long to find level and north, s.
    align: float | None
    #: Align by the means alone, without the filter that finds biases, too.
    coarse: bool | None
    #: The heading to start from with `align`, degrees.
    heading: float | None
    #: End at this time of the recording, s.
    until: float | None
    #: Samples per second, instead of what the time stamps say.
    rate: float | None
    #: The altitude that the vertical is held to: metres, or a file.
    height: float | str | PathLike[str] | None
    #: Keep every N-th row, or a row each so many seconds, as in "10s".
    every: int | str | None
    #: Positions and velocities that aid it: a file, the `gnss` of an emulation, or arrays.
    gnss: Fixes | None
    #: From the inertial unit to the antenna, forward, right, down, m.
    lever_arm: str | tuple[float, float, float] | list[float] | None
    #: How late the stamps of `gnss` are, s.
    gnss_lag: float | None
    #: How much later than the positions its velocities are, s, or "off".
    velocity_lag: float | Literal["off"] | None
    #: Standard deviations where it has none: positions level and down, m, velocities, m/s.
    gnss_sigma: str | tuple[float, float, float] | list[float] | None
    #: Smooths the flight, too.
    smooth: bool | None
    #: RTKLIB's time tags of the stream: a file.
    time_tag: str | PathLike[str] | None
    #: What the sensors are like: a scene with the sections gyro, accelerometer and filter, or those alone.
    sensors: str | PathLike[str] | Mapping[str, Any] | None
    #: Spans whose fixes are hidden from the navigator, from and to, s.
    withhold: Sequence[tuple[float, float]] | None
