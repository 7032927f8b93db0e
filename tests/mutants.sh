#!/usr/bin/env bash
# Changes core in one place at a time and looks whether a test notices: a sample of all the changes that
# cargo-mutants knows. By hand, not in CI: each takes a build and the tests.
#   tests/mutants.sh [COUNT [SEED]]    200 and 1 unless told
# It ends with 1 where fewer than 95 % are caught; out/mutants has what became of each.
set -euo pipefail
cd "$(dirname "$0")/.."

count=${1:-200}
seed=${2:-1}
least=95
if ! cargo mutants --version >/dev/null 2>&1; then
    echo "skipped: no cargo-mutants (cargo install cargo-mutants)"
    exit 0
fi
mkdir -p out
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# An endless stream of bytes for `shuf`, the same for one seed.
stream() { yes "schuler $seed" | head -c 10000000; }
cargo mutants --package schuler --list | sort >"$scratch/all"
shuf --random-source=<(stream) --head-count="$count" "$scratch/all" >"$scratch/chosen"
echo "$(wc -l <"$scratch/chosen") of $(wc -l <"$scratch/all") changes, seed $seed"

# Each by its whole name, every character for itself.
names=()
while IFS= read -r name; do
    names+=(--re "^$(sed 's/[][\\.^$*+?(){}|]/\\&/g' <<<"$name")\$")
done <"$scratch/chosen"
status=0
CARGO_PROFILE_DEV_DEBUG=false cargo mutants --package schuler --test-package schuler-tests,schuler-host \
    --output out/mutants --baseline skip --timeout 600 "${names[@]}" || status=$?
# 2 is changes that no test notices, 3 tests that do not end: both are in the counts.
case $status in 0 | 2 | 3) ;; *) exit "$status" ;; esac

lines() { wc -l <"out/mutants/mutants.out/$1.txt"; }
caught=$(($(lines caught) + $(lines timeout)))
missed=$(lines missed)
[ $((caught + missed)) -gt 0 ] || { echo "mutants: nothing was tried" >&2; exit 1; }
echo "$caught caught, $missed missed, $(lines unviable) do not compile"
cat out/mutants/mutants.out/missed.txt
[ $((100 * caught)) -ge $((least * (caught + missed))) ]
