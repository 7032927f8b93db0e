#!/usr/bin/env bash
# Changes core in one place at a time and looks whether a test notices: a sample of all the changes that
# cargo-mutants knows. By hand, not in CI: each takes a build and the tests.
#   tests/mutants.sh [COUNT [SEED]]    200 and 1 unless told
# A change goes through three sets of tests, and only as far as it is not noticed: those that need core alone, all
# of the package `schuler-tests`, and those of simulator and host. The last two build the simulator anew each time.
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
results=$PWD/out/mutants
tree=$results/tree
mkdir -p "$results"
rm -rf "$tree" "$results"/[123]
mkdir -p "$tree"
# What is not committed is tried, too. The changes are made in this copy, so that none is ever left here.
git ls-files -z --cached --others --exclude-standard | tar --create --null --files-from=- --ignore-failed-read | tar --extract --directory="$tree"
# Examples are built with core's tests, and tell nothing of a change.
sed -i '/^\[\[example/,$d' "$tree/core/Cargo.toml"
rm -r "$tree/core/examples"

# The tests that need core alone, as a package of their own: a change of core builds neither simulator nor host.
alone=$tree/alone
mkdir -p "$alone/src/rounding"
cp -r "$tree/tests/tests" "$alone/tests"
cp "$tree/tests/src/numbers.rs" "$alone/src"
cp "$tree/host/simulator/src/rounding/split_mix.rs" "$alone/src/rounding"
sed -i 's/^members = \[/&"alone", /' "$tree/Cargo.toml"
cat >"$alone/Cargo.toml" <<'END'
[package]
name = "schuler-alone"
edition.workspace = true
autotests = false

[lib]
name = "schuler_tests"
test = false
doctest = false

[[test]]
name = "all"
path = "tests/main.rs"

[dependencies]
schuler = { workspace = true, features = ["full", "std"] }

[dev-dependencies]
astro-float-num.workspace = true
END
cat >"$alone/src/lib.rs" <<'END'
extern crate self as schuler_simulator;
pub mod rounding {
    pub mod split_mix;
}
mod numbers;
pub use numbers::*;
END
sed -i '0,/^mod /s//extern crate schuler_tests as schuler_simulator;\n\nmod /' "$alone/tests/main.rs"
more='schuler_(host|scenes|speed|constants)|schuler_simulator::([^r]|r[^o])|schuler_tests::(\{.*)?(Course|at_rest|baseline)'
more+='|(serde|serde_json|toml|tempfile|clap)::'
# Who uses one of those left out is left out, too.
while files=$(grep -rlE "$more" "$alone/tests"); do
    for file in $files; do
        parent=$(dirname "$file")
        [ "$parent" = "$alone/tests" ] && parent=$parent/main.rs || parent=$parent/mod.rs
        module=$(basename "$file" .rs)
        sed -i "/^mod $module;/d" "$parent"
        rm "$file"
        more+="|super::$module::"
    done
done

# An endless stream of bytes for `shuf`, the same for one seed.
stream() { yes "schuler $seed" | head -c 10000000; }
cargo mutants --dir "$tree" --package schuler --list | sort >"$results/all.txt"
shuf --random-source=<(stream) --head-count="$count" "$results/all.txt" >"$results/left.txt"
echo "$(wc -l <"$results/left.txt") of $(wc -l <"$results/all.txt") changes, seed $seed"

export CARGO_TARGET_DIR=$results/target CARGO_INCREMENTAL=1
caught=0
unviable=0
# try NUMBER PACKAGES: what is left against the tests of some packages; what they miss is left then.
try() {
    local names=() status=0 name outcome=$results/$1/mutants.out
    [ -s "$results/left.txt" ] || return 0
    # Each by its whole name, every character for itself.
    while IFS= read -r name; do
        names+=(--re "^$(sed 's/[][\\.^$*+?(){}|]/\\&/g' <<<"$name")\$")
    done <"$results/left.txt"
    # The tests as they stand must pass: what fails anyhow would catch everything.
    cargo test --manifest-path "$tree/Cargo.toml" $(printf -- '--package %s ' ${2//,/ }) --quiet >"$results/$1.log" 2>&1 ||
        { echo "mutants: the tests of $2 fail without a change: $results/$1.log" >&2; exit 1; }
    cargo mutants --dir "$tree" --in-place --package schuler --test-package "$2" --output "$results/$1" \
        --baseline skip --timeout 900 "${names[@]}" || status=$?
    # 2 is changes that no test notices, 3 tests that do not end: both are in the counts.
    case $status in 0 | 2 | 3) ;; *) exit "$status" ;; esac
    caught=$((caught + $(cat "$outcome"/{caught,timeout}.txt | wc -l)))
    unviable=$((unviable + $(wc -l <"$outcome/unviable.txt")))
    cp "$outcome/missed.txt" "$results/left.txt"
    echo "$2: $(wc -l <"$results/left.txt") left"
}
try 1 schuler,schuler-alone
try 2 schuler-tests
try 3 schuler-simulator,schuler-host

missed=$(wc -l <"$results/left.txt")
[ $((caught + missed)) -gt 0 ] || { echo "mutants: nothing was tried" >&2; exit 1; }
echo "$caught caught, $missed missed, $unviable do not compile"
cat "$results/left.txt"
[ $((100 * caught)) -ge $((least * (caught + missed))) ]
