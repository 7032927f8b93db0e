"""Exceptions. Their texts are those of the program `schuler`."""

from __future__ import annotations


class Error(Exception):
    """Whatever goes wrong."""


class InputError(Error, ValueError):
    """What was given is not to be had: where it stands, what is wrong, what would be accepted."""

    def __init__(
        self,
        text: str,
        file: str | None = None,
        line: int | None = None,
        key: str | None = None,
        what: str = "",
        accepted: str = "",
    ) -> None:
        super().__init__(text)
        #: The file, as it was given; None for what no file says.
        self.file = file
        #: The line, from 1.
        self.line = line
        #: The key of a scene, the column of a table, or the option.
        self.key = key
        #: What is wrong.
        self.what = what
        #: What would be accepted.
        self.accepted = accepted


class FlightError(Error):
    """A flight ended early."""

    def __init__(self, text: str, flown: object | None = None) -> None:
        super().__init__(text)
        #: What was flown until then: a Flight of `run`, a Table of `Navigator.fly`, else None.
        self.flown = flown
