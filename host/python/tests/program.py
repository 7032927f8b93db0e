"""The program `schuler`, whose every bit the package has; SCHULER names it."""

from __future__ import annotations

import csv
import json
import os
import shlex
import subprocess
from pathlib import Path
from typing import Any

import numpy as np

import schuler
import schuler.types

GOLDEN = Path(os.environ["SCHULER_ROOT"]) / "tests/golden"
TURNS = GOLDEN / "turns.toml"


def program(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Runs it, with or without success."""
    command = [*shlex.split(os.environ["SCHULER"]), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, cwd=os.environ["SCHULER_ROOT"])


def done(*arguments: object) -> str:
    """Runs it with success."""
    ran = program(*arguments)
    assert ran.returncode == 0, ran.stderr
    return ran.stdout


def complaint(*arguments: object) -> str:
    """What it complains of."""
    ran = program(*arguments)
    assert ran.returncode != 0
    return ran.stderr.removeprefix("schuler: ").removesuffix("\n")


def summary(folder: Path) -> dict[str, Any]:
    tree = json.loads((folder / "summary.json").read_text())
    assert isinstance(tree, dict)
    return tree


def columns(file: Path) -> dict[str, schuler.types.Array]:
    """The columns of a file; of numbers that are none it has nothing or NaN."""
    with file.open() as lines:
        header, *rows = csv.reader(lines)
    numbers = np.array([[float(field or "nan") for field in row] for row in rows])
    return {name: numbers[:, place] for place, name in enumerate(header)}


def assert_same(table: schuler.Table, file: Path) -> None:
    """Every column of a file is in the table, bit for bit."""
    for name, numbers in columns(file).items():
        assert len(numbers) == len(table) > 0
        np.testing.assert_array_equal(table[name], numbers, err_msg=f"{file.name}: {name}")
