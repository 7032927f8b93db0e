#!/usr/bin/env bash
# The Python package: its wheel in a clean environment, every bit beside the program's, its stubs, threads, examples,
# notebook, and the README's use. Without Python or its packages it skips with a line that says so; with CI set
# nothing may be missing. SCHULER may name the program, built already, and WHEEL the folder of a wheel.
set -euo pipefail
cd "$(dirname "$0")/.."

build=(maturin==1.16.0)
packages=(numpy==2.4.6 pandas==3.1.1 matplotlib==3.11.2 mypy==2.4.1)
tools=$(realpath -m "${CARGO_TARGET_DIR:-target}/tools/maturin")

missing() {
    if [ -n "${CI:-}" ]; then
        echo "python: $1" >&2
        exit 1
    fi
    echo "skipped: $1"
    exit 0
}

if [ -n "${CI:-}" ] && ! python3 -c 'import ensurepip, venv' 2>/dev/null; then
    apt-get update -qq >/dev/null
    apt-get install -y -qq --no-install-recommends python3 python3-venv >/dev/null
fi
python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || missing "no Python from 3.11 on"

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

wheels=${WHEEL:-$out/wheels}
if [ -z "${WHEEL:-}" ]; then
    if ! "$tools/bin/maturin" --version >/dev/null 2>&1; then
        { python3 -m venv "$tools" && "$tools/bin/pip" install --quiet "${build[@]}"; } ||
            missing "${build[*]} cannot be installed"
    fi
    "$tools/bin/maturin" build --quiet --release --locked --manifest-path host/python/Cargo.toml --out "$wheels"
fi
echo "wheel: $(basename "$wheels"/*.whl), $(stat -c %s "$wheels"/*.whl) bytes"

# Nothing but the wheel and what it asks for, away from the sources: the README's use.
python3 -m venv "$out/python"
python=$out/python/bin/python
"$out/python/bin/pip" install --quiet --disable-pip-version-check "$wheels"/*.whl "${packages[0]}" ||
    missing "${packages[0]} cannot be installed"
sed -n '/^```python$/,/^```$/p' README.md | sed '/^```/d' >"$out/readme.py"
[ -s "$out/readme.py" ] || { echo "python: the README has no use of Python" >&2; exit 1; }
(cd "$out" && "$python" readme.py)

"$out/python/bin/pip" install --quiet --disable-pip-version-check "${packages[@]}" ||
    missing "${packages[*]} cannot be installed"
root=$PWD
SCHULER=${SCHULER:-cargo run --quiet --release --locked --}
export SCHULER SCHULER_ROOT=$root MPLBACKEND=Agg
tests=$root/host/python/tests
cd "$out"
"$python" -m unittest discover --start-directory "$tests" --top-level-directory "$tests"

# Stubs are right by a checker's rules, and those of what is there.
"$python" -m mypy --strict --package schuler
MYPYPATH=$tests "$python" -m mypy --strict "$tests"/*.py "$root"/host/python/examples/*.py
"$python" -m mypy.stubtest schuler._schuler --ignore-disjoint-bases

for example in "$root"/host/python/examples/*.py; do
    picture=$(basename "$example" .py).png
    "$python" "$example" "$picture" >"$picture.txt"
    "$python" -c 'import sys; assert open(sys.argv[1], "rb").read(8) == b"\x89PNG\r\n\x1a\n"' "$picture"
done
"$python" "$tests/notebook.py" "$root/host/python/examples/notebook.ipynb" >/dev/null
