#!/usr/bin/env bash
# Every combination of core's features for a Cortex-M4F, without warnings; a build of the mechanization
# alone takes libm and no procedural macro; and what each feature costs.
#   tests/features.sh
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/target.sh

features=(trajectory sensor allan link aiding micromath defmt)
fail() { echo "features: $*" >&2; exit 1; }

# crates FEATURES: what cargo compiles besides core, one a line.
crates() {
    cargo tree --locked --package schuler --no-default-features --features "$1" --target "$target" \
        --edges normal,build --prefix none --format '{p}' | sed 's/ (\*)$//; /^schuler /d' | sort -u
}

alone=$(crates "")
case $alone in
"libm v"*) [ "$(wc -l <<<"$alone")" = 1 ] || fail "the mechanization needs more than libm: $alone" ;;
*) fail "the mechanization needs: $alone" ;;
esac
# What is not seen where it is cannot be missed where it is not.
grep -q '^syn v' <<<"$(crates defmt)" || fail "syn is not seen in a build with defmt"
for feature in trajectory sensor allan aiding micromath trajectory,sensor,allan; do
    if grep -E '^syn v|\(proc-macro\)' <<<"$(crates "$feature")"; then
        fail "a build with \"$feature\" takes a procedural macro"
    fi
done

count=0
for ((set = 0; set < 1 << ${#features[@]}; set++)); do
    chosen=()
    for ((i = 0; i < ${#features[@]}; i++)); do
        ((set >> i & 1)) && chosen+=("${features[i]}")
    done
    words=$(IFS=,; echo "${chosen[*]}")
    status=0
    RUSTFLAGS="-D warnings" cargo_command=check build_core thumbv7em-none-eabihf "$words" --quiet || status=$?
    if [ "$status" = $no_compiler ]; then
        skip_without_compiler "$status"
        exit 0
    fi
    [ "$status" = 0 ] || fail "core does not build with \"$words\""
    count=$((count + 1))
done
echo "$count combinations of ${features[*]} build for $target"

# code FILE: the machine code in a library or an image, bytes.
code() { size -A "$1" | awk '$1 ~ /^\.text/ || $1 ~ /^\.rodata/ { sum += $2 } END { print sum + 0 }'; }

builds=$(realpath -m "${CARGO_TARGET_DIR:-target}")/features
echo "| features | crates besides core | code in the library, bytes | more in a navigator that does not use it |"
echo "|---|--:|--:|--:|"
first=
for words in "" trajectory sensor allan link aiding full micromath defmt; do
    # Machine code, not what the linker would optimise further.
    CARGO_TARGET_DIR=$builds CARGO_PROFILE_RELEASE_LTO=off build_core "$target" "$words" --quiet
    library=$(code "$builds/$target/release/libschuler.rlib")
    (cd tests/footprint && CARGO_TARGET_DIR=$builds build_package "$target" "$words" --quiet)
    image=$(code "$builds/$target/release/footprint")
    first=${first:-$image}
    needs=$(crates "$words" | sed 's/ .*//' | xargs | sed 's/ /, /g')
    echo "| ${words:-none} | $(crates "$words" | wc -l): $needs | $library | $((image - first)) |"
done
