"""Strapdown inertial navigation: flights, sensors with errors, navigators, and their drift beside theory.

    >>> import schuler
    >>> flight = schuler.run("paper", duration=60)
    >>> flight.digest
    '...'

Each command of the program `schuler` is a function here, with the same names of options, the same texts of errors and
the same bits. Axes of the body are forward, right, down, those of navigation north, east, down; the unit of a number is
in its name. A sample's time is the end of its interval.
"""

from schuler._schuler import (
    Aided,
    AidedEnsemble,
    Aligned,
    Allan,
    Emulation,
    Ensemble,
    Flight,
    Navigator,
    Replay,
    Scene,
    State,
    Steps,
    Table,
    Trajectory,
    __version__,
    aided_ensemble,
    align,
    allan,
    datasheet,
    emulate,
    ensemble,
    navigators,
    replay,
    run,
    scene_text,
    scenes,
    steps,
)
from schuler.errors import Error, FlightError, InputError

__all__ = [
    "Aided",
    "AidedEnsemble",
    "Aligned",
    "Allan",
    "Emulation",
    "Ensemble",
    "Error",
    "Flight",
    "FlightError",
    "InputError",
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
