"""Runs the cells of a notebook; what a cell ends with must show itself, and the last must end in a picture."""

from __future__ import annotations

import ast
import json
import sys
from pathlib import Path

import matplotlib.pyplot as plt


def run(path: Path, picture: Path) -> None:
    names: dict[str, object] = {}
    shown = 0
    for cell in json.loads(path.read_text())["cells"]:
        if cell["cell_type"] != "code":
            continue
        lines = "".join(cell["source"]).splitlines()
        tree = ast.parse("\n".join(line for line in lines if not line.startswith("%")))
        last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, str(path), "exec"), names)
        if isinstance(last, ast.Expr):
            value = eval(compile(ast.Expression(last.value), str(path), "eval"), names)
            html = getattr(value, "_repr_html_", None)
            assert (html() if html else repr(value)), last
            shown += 1
    assert shown > 4, shown
    assert plt.get_fignums(), "no picture"
    plt.savefig(picture)


if __name__ == "__main__":
    run(Path(sys.argv[1]), Path(sys.argv[2]))
