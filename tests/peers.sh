#!/usr/bin/env bash
# The same files of `aided-drive` through `schuler replay`, kinavis-ins, pyins and KF-GINS, with fixes of position and
# velocity and with positions alone: errors, whether σ is right, and CPU time of each filter alone. By hand: pyins takes
# a minute and a half of CPU time for a flight. What is missing is said, and left out.
#   tests/peers.sh [FLIGHTS [FOLDER]]    16 flights by default; FOLDER, a new one, keeps the files
# SCHULER is the program, where it is built already. KF_GINS is the folder of its sources
# (github.com/i2Nav-WHU/KF-GINS), which bring Eigen along. PYINS is how many of the flights pyins takes, 0 for none of
# them: where these are fewer than all, there is another table for them.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/venv.sh

flights=${1:-16}
if [[ ! $flights =~ ^[1-9][0-9]{0,3}$ ]]; then
    echo "tests/peers.sh: $flights: accepted: a number of flights from 1 to 9999" >&2
    exit 2
fi
by_pyins=${PYINS:-$flights}
if [[ ! $by_pyins =~ ^(0|[1-9][0-9]{0,3})$ ]] || ((by_pyins > flights)); then
    echo "tests/peers.sh: PYINS=$by_pyins: accepted: a number of flights up to $flights" >&2
    exit 2
fi
export CARGO_TARGET_DIR
CARGO_TARGET_DIR=$(realpath -m "${CARGO_TARGET_DIR:-target}")
build_program
tools=$CARGO_TARGET_DIR/tools/peers
mkdir -p "$tools"
if ! cargo fetch --locked --quiet --manifest-path tests/peers/Cargo.toml; then
    echo "skipped: kinavis-ins cannot be had"
    exit 0
fi
CARGO_TARGET_DIR=$tools cargo build --release --locked --quiet --manifest-path tests/peers/Cargo.toml
peers=$tools/release/peers
if [ -n "${2:-}" ]; then
    folder=$(realpath -m "$2")
    mkdir "$folder" || { echo "tests/peers.sh: $2: accepted: a folder that is not there yet" >&2 && exit 2; }
else
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
fi

# emulate KIND: a folder for each flight, the scene's runs from 0 on.
emulate() {
    local run here
    for ((run = 0; run < flights; run++)); do
        # In the order of their numbers for every *.
        here=$folder/$1/$(printf '%04d' "$run")
        mkdir -p "$here"
        cp "$folder/$1.toml" "$here/scene.toml"
        "$SCHULER" emulate "$here/scene.toml" --run "$run" --out "$here/imu.csv" --gnss "$here/gnss.csv" \
            --truth "$here/truth.csv" >"$here/emulate.txt"
        "$peers" settings "$here"
    done
}

# replay FOLDER NAME PRECISION
replay() {
    "$SCHULER" replay --imu "$1/imu.csv" --gnss "$1/gnss.csv" --sensors "$1/scene.toml" \
        --initial "$1/initial.toml" --precision "$3" --out "$1/$2.csv" >"$1/$2.txt"
}

"$SCHULER" scenes aided-drive >"$folder/both.toml"
sed 's/^\[gnss\]$/&\nreports = "position"/' "$folder/both.toml" >"$folder/positions.toml"
for kind in both positions; do
    emulate $kind
    for here in "$folder/$kind"/*/; do
        replay "$here" schuler f64
        replay "$here" schuler-f32 f32
        "$peers" fly "$here"
    done
done

if [ -z "${KF_GINS:-}" ]; then
    echo "skipped: KF-GINS: KF_GINS names no folder of its sources"
elif g++ -std=c++17 -O3 -DNDEBUG -w -I "$KF_GINS/src" -I "$KF_GINS/ThirdParty/eigen-3.3.9" -o "$tools/fly_kf_gins" \
    tests/peers/fly_kf_gins.cpp "$KF_GINS"/src/kf-gins/*.cpp; then
    # It takes no velocities.
    "$tools/fly_kf_gins" "$folder"/positions/*/ >"$folder/kf_gins.txt"
else
    echo "skipped: KF-GINS: not built from $KF_GINS"
fi

# all KIND [COUNT]: the folders of a kind's flights, or of the first of them.
all() {
    local here=("$folder/$1"/*/)
    printf '%s\n' "${here[@]:0:${2:-$flights}}"
}

python=
if [ "$by_pyins" != 0 ]; then
    # Where it cannot be had, that is said, and `python` stays empty.
    python=$(python_with pyins python-ins==1.0.1 numba==0.68.1 numpy==2.4.6 pandas==3.1.1 scipy==1.17.1 >&2 && echo "$python")
fi
if [ -n "$python" ]; then
    # A process for each of two processors; none of them takes more.
    { all both "$by_pyins" && all positions "$by_pyins"; } |
        OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 \
            xargs -d '\n' -n "$by_pyins" -P 2 "$python" tests/peers/fly_pyins.py
fi

for kind in both positions; do
    if [ $kind = both ]; then title="positions and velocities"; else title="positions alone"; fi
    printf '\n%s\n\n' "$title"
    all $kind | xargs -d '\n' "$peers" table
    if [ -n "$python" ] && ((by_pyins < flights)); then
        echo
        all $kind "$by_pyins" | xargs -d '\n' "$peers" table
    fi
done
