#!/usr/bin/env bash
# Shards of an ensemble through HyperQueue: a server, two workers, eight shards on this machine, put together and
# compared byte for byte with the whole. Without Python or its package it skips with a line that says so; with CI set
# nothing may be missing. SCHULER may name the program, built already.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/venv.sh

python_with hyperqueue hyperqueue==0.27.0
schuler=${SCHULER:-cargo run --quiet --release --locked --}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

# A number of runs that eight does not divide.
ensemble="ensemble paper --duration 120 --runs 203"
$schuler $ensemble --keep --out "$out/whole" >/dev/null
if ! "$python" tests/shards.py 2 8 "$out/parts" $schuler $ensemble >"$out/said" 2>&1; then
    cat "$out/said" >&2
    cat "$out"/parts/*.err >&2 2>/dev/null || true
    exit 1
fi
$schuler ensemble merge "$out"/parts/*.part --keep --out "$out/merged" >/dev/null
diff -r "$out/whole" "$out/merged"

# A comparison that finds nothing wrong with another seed finds nothing anywhere, nor does a merge without a shard.
$schuler $ensemble --seed 2 --keep --out "$out/other" >/dev/null
if diff -r "$out/other" "$out/merged" >/dev/null; then
    echo "hyperqueue: another seed is not told from this one" >&2
    exit 1
fi
rm "$out/parts/shard-5-of-8.part"
if $schuler ensemble merge "$out"/parts/*.part --out "$out/fewer" >/dev/null 2>"$out/said"; then
    echo "hyperqueue: seven of eight shards are taken for the whole" >&2
    exit 1
fi
grep -q "of 8 shards there is no shard 5" "$out/said"
echo "203 runs in 8 shards on 2 workers: byte for byte the whole"
