#!/usr/bin/env bash
# The Python package: its wheel in a clean environment with the README's use, every bit beside the program's, its
# stubs, threads, examples and the notebook. Without Python or its packages it skips with a line that says so; with CI
# set nothing may be missing. SCHULER may name the program, built already, WHEEL the folder of a wheel, and PROFILE
# another profile than the package's own to build it with: `release` shares what the program is built from.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/venv.sh

fail() {
    echo "python: $*" >&2
    exit 1
}

profile=${PROFILE:-wheel}
# The wheel's bytes, at most; with another profile than its own that is of no interest.
most=3700000
[ "$profile" = wheel ] || most=5000000

if ! python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
    [ -z "${CI:-}" ] || install python3 python3-venv || fail "no Python from 3.11 on"
    [ -n "${CI:-}" ] || { echo "skipped: no Python from 3.11 on" && exit 0; }
fi
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
root=$PWD

wheels=${WHEEL:-$out/wheels}
if [ -z "${WHEEL:-}" ]; then
    python_with maturin maturin==1.16.0
    # Functions that are alike stand side by side, where the linker can do that: an archive of them is smaller.
    order=(-Clink-arg=-Wl,--bp-compression-sort=both)
    rustc --crate-type cdylib "${order[@]}" -o "$out/order.so" - </dev/null 2>/dev/null || order=()
    "$python" -m maturin build --quiet --profile "$profile" --locked --interpreter "$python" --compression-level 9 \
        --manifest-path host/python/Cargo.toml --out "$wheels" -- ${order[@]+"${order[@]}"}
fi
wheel=$(echo "$wheels"/*.whl)
bytes=$(stat -c %s "$wheel")
echo "$(basename "$wheel"): $bytes bytes"
[ "$bytes" -le $most ] || fail "the wheel has more than $most bytes"
build_program

# The README's use, away from the sources, with nothing but the wheel and what it asks for: once for each Python here.
awk '/^```python$/ { inside = 1; next } /^```$/ { inside = 0 } inside' README.md >"$out/readme.py"
[ -s "$out/readme.py" ] || fail "README.md has no Python"
tried=" "
for name in python3 python3.11 python3.12 python3.13 python3.14; do
    version=$("$name" -c 'import ensurepip, venv, platform; print(platform.python_version())' 2>/dev/null) || continue
    [[ $tried != *" $version "* ]] || continue
    tried+="$version "
    "$name" -m venv "$out/$version"
    clean=$out/$version/bin/python
    "$clean" -m pip install --quiet --disable-pip-version-check "$wheel" || fail "$wheel cannot be installed"
    (cd "$out" && "$clean" readme.py)
done
echo "the README's use, in clean environments: Python$tried"

python_with python numpy==2.4.6 pandas==3.1.1 matplotlib==3.11.2 mypy==2.4.1
"$python" -m pip install --quiet --disable-pip-version-check --no-deps --force-reinstall "$wheel"
export SCHULER SCHULER_ROOT=$root MPLBACKEND=Agg PYTHONDONTWRITEBYTECODE=1
tests=$root/host/python/tests
cd "$out"
"$python" -m unittest discover --start-directory "$tests" --top-level-directory "$tests"

# The stubs are right by a checker's rules, and say what is there.
"$python" -m mypy --strict --package schuler
MYPYPATH=$tests "$python" -m mypy --strict "$tests"/*.py "$root"/host/python/examples/*.py
"$python" -m mypy.stubtest schuler._schuler --ignore-disjoint-bases

# picture FILE: a PNG that is more than white.
picture() {
    "$python" - "$1" <<'END' || fail "$1 shows nothing"
import sys
from matplotlib import image
assert image.imread(sys.argv[1])[..., :3].std() > 0.02
END
}
for example in "$root"/host/python/examples/*.py; do
    name=$(basename "$example" .py)
    "$python" "$example" "$name.png" >"$name.txt" || fail "$name: $(cat "$name.txt")"
    picture "$name.png"
done
"$python" "$tests/notebook.py" "$root/host/python/examples/notebook.ipynb" notebook.png >/dev/null
picture notebook.png
echo "examples and notebook: seven pictures"
