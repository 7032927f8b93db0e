#!/usr/bin/env bash
# Fuzzes what reads bytes from a line, each target of tests/fuzz for so many seconds.
#   tests/fuzz.sh [SECONDS]    60 unless told
# It takes cargo-fuzz and a nightly compiler; without them it is skipped with a line that says so.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:-60}
if ! cargo +nightly --version >/dev/null 2>&1; then
    echo "skipped: no nightly compiler (rustup toolchain install nightly)"
    exit 0
fi
if ! cargo fuzz --version >/dev/null 2>&1; then
    echo "skipped: no cargo-fuzz (cargo install cargo-fuzz)"
    exit 0
fi
for target in $(cargo fuzz list --fuzz-dir tests/fuzz); do
    cargo +nightly fuzz run --fuzz-dir tests/fuzz "$target" -- -max_total_time="$seconds"
done
