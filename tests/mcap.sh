#!/usr/bin/env bash
# The ROS 2 messages of `run`, `emulate` and `replay`, read by Python's mcap and mcap-ros2-support: every number is
# that of the tables beside them. Without Python or its packages it skips with a line that says so; with CI set
# nothing may be missing. SCHULER may name the program, built already.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/venv.sh

python_with mcap mcap==1.6.0 mcap-ros2-support==0.6.0
schuler=${SCHULER:-cargo run --quiet --release --locked --}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
check() { "$python" tests/messages.py "$@"; }

# One that turns in every direction, one with sensor errors, and one across the antimeridian.
for flight in manoeuvre:100 paper:20 drive:100; do
    scene=${flight%:*} rate=${flight#*:}
    folder=$out/$scene
    $schuler run "$scene" --rate "$rate" --duration 20 --out "$folder" --no-report --rows --mcap "$folder/run.mcap" >/dev/null
    $schuler emulate "$scene" --rate "$rate" --duration 20 --out "$folder/imu.csv" --mcap "$folder/emulate.mcap" >/dev/null
    $schuler replay --imu "$folder/imu.csv" --initial "$folder/initial.toml" --out "$folder/again.csv" \
        --mcap "$folder/replay.mcap" >/dev/null
    check "$folder/run.mcap" "$rate" "$folder/imu.csv" "$folder/truth.csv" "$folder/nav.csv"
    check "$folder/emulate.mcap" "$rate" "$folder/imu.csv" "$folder/truth.csv"
    check "$folder/replay.mcap" "$rate" - - "$folder/again.csv"
done

# A check that finds nothing wrong with another motion finds nothing anywhere.
if check "$out/drive/emulate.mcap" 100 "$out/drive/imu.csv" "$out/manoeuvre/truth.csv" 2>/dev/null; then
    echo "mcap: the truth of another flight is not told from this one's" >&2
    exit 1
fi
