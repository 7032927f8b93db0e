#!/usr/bin/env bash
# Counts instructions per sample with Callgrind and compares them with the stored ones.
#   tests/instructions.sh           compares with tests/instructions.toml
#   tests/instructions.sh --store   stores what is counted in its place
# Without Valgrind or Gungraun's runner it skips with a line that says so; with CI set it installs them.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/target.sh

version=$(sed -n '/^name = "gungraun"$/{n;s/version = "\(.*\)"/\1/p}' Cargo.lock)
tools=$(realpath -m "${CARGO_TARGET_DIR:-target}/tools")
export PATH="$tools/bin:$PATH"

has_runner() { [ "$(gungraun-runner --version 2>/dev/null)" = "gungraun-runner $version" ]; }

if [ -n "${CI:-}" ]; then
    if ! command -v valgrind >/dev/null; then
        install valgrind libc6-dbg
    fi
    has_runner || cargo install --quiet --locked --debug --root "$tools" \
        --target-dir "$tools/target" "gungraun-runner@$version"
fi
if ! command -v valgrind >/dev/null; then
    echo "skipped: no valgrind (apt-get install valgrind)"
    exit 0
fi
if ! has_runner; then
    echo "skipped: no gungraun-runner $version (cargo install gungraun-runner --version $version)"
    exit 0
fi

summaries=$(mktemp -d)
trap 'rm -rf "$summaries"' EXIT
# A home of its own: counts of an earlier run would be mixed into the summaries.
GUNGRAUN_HOME="$summaries/home" cargo bench --quiet --locked --package schuler-speed \
    --bench instructions -- --output-format=json >"$summaries/counts.json"
tool schuler-tests instructions "$@" tests/instructions.toml <"$summaries/counts.json"
