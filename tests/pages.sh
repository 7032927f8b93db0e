#!/usr/bin/env bash
# The pages of every command in headless Chromium: nothing on the console, every chart drawn, cursor, zoom, legend and
# files at work, nothing serious for axe-core, in light, dark, 380 pixels wide and on paper.
# SCHULER is the program, where it is built already; SHOTS a folder for pictures of the pages.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/venv.sh

python_with pages playwright==1.65.2 axe-core-python==0.1.0
chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
if [ -z "$chromium" ]; then
    install chromium || true
    chromium=$(command -v chromium || true)
fi
if [ -z "$chromium" ]; then
    if [ -n "${CI:-}" ]; then
        echo "chromium cannot be installed" >&2
        exit 1
    fi
    echo "skipped: no chromium"
    exit 0
fi

if [ -z "${SCHULER:-}" ]; then
    cargo build --release --locked --quiet
    SCHULER=${CARGO_TARGET_DIR:-target}/release/schuler
fi
schuler=$(realpath "$SCHULER")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
tests=$PWD/tests
cd "$folder"
# make NAME STATUS COMMAND …: what it says is of interest only where it ends otherwise.
make() {
    local status=0
    "$schuler" "${@:3}" >"$1.txt" 2>&1 || status=$?
    if [ "$status" != "$2" ]; then
        cat "$1.txt"
        echo "tests/pages.sh: $1 ended with status $status, not $2" >&2
        exit 1
    fi
}

make run 0 run paper --out run
make dense 0 run vibration --duration 20 --out dense
make perfect 0 run paper-perfect --duration 60 --out perfect
make emulate 0 emulate drive --duration 120 --out imu.csv --truth truth.csv
make replay 0 replay --imu imu.csv --initial initial.toml --reference truth.csv --out replay/
make ensemble 0 ensemble paper --runs 64 --duration 600 --budget --out ensemble
"$schuler" scenes aided-drive >drive.toml
printf '\n[filter]\nsmoother = true\n' >>drive.toml
make aided 0 ensemble drive.toml --runs 24 --budget 8 --out aided
make smoothed 0 run drive.toml --out smoothed
make allan 0 allan paper --out allan
make frontier 0 frontier --quick --scene stationary --scene coning --rate 50 --out frontier
make stress 0 stress --case coning --out stress
make hil 0 hil paper --duration 60 --faults all=0.02 --out hil
make stream 0 hil paper --duration 3 --stream --out stream
chain=f64-local-level-taylor-2-4-2
make record 0 audit record paper --duration 5 --configuration "$chain" --out chains
make verify 0 audit verify chains --out verify
make other 0 audit record paper --duration 5 --seed 2 --configuration "$chain" --out others
make compare 1 audit compare chains others --out compare
make sensitivity 0 audit sensitivity paper --duration 60 --out sensitivity

"$python" "$tests/pages.py" "$chromium" "$folder"

# What finds nothing wrong with a page that fails, asks the network and has a picture without words finds nothing
# anywhere.
mkdir -p planted/stress
sed 's|<main>|<main><img src="http://127.0.0.1:9/x.png"><script>throw new Error("planted")</script>|' \
    stress/stress.html >planted/stress/stress.html
if "$python" "$tests/pages.py" "$chromium" planted stress >planted.txt 2>&1; then
    echo "tests/pages.sh: a page with faults is taken for one without" >&2
    exit 1
fi
for fault in "error: planted" "http://127.0.0.1:9/x.png" image-alt; do
    if ! grep -q "$fault" planted.txt; then
        cat planted.txt
        echo "tests/pages.sh: $fault is not found" >&2
        exit 1
    fi
done
