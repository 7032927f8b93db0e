#!/usr/bin/env bash
# Links the smallest navigator for a Cortex-M4F and looks at its symbols: a room of core that is not
# used adds nothing to it, and nothing in it can panic.
set -euo pipefail
cd "$(dirname "$0")/footprint"
. ../target.sh

# rooms IMAGE: the rooms of core that some symbol belongs to.
rooms() { nm --demangle "$1" | grep -o 'schuler::[a-z_]*' | sort -u | sed 's/schuler:://' | xargs; }

image="${CARGO_TARGET_DIR:-target}/$target/release/footprint"
fail() { echo "footprint: $*" >&2; exit 1; }

build_package "$target" full || {
    skip_without_compiler $?
    exit 0
}
navigator=$(rooms "$image")
for room in $navigator; do
    case $room in
    strapdown | math | earth | sample | solution | record) ;;
    *) fail "the room $room is linked though nothing uses it" ;;
    esac
done
[ -n "$navigator" ] || fail "no symbol of core in $image"
if nm --demangle "$image" | grep -E 'core::(panicking|fmt)|slice_index_fail'; then
    fail "the navigator has a panicking path"
fi
bytes=$(size -A "$image" | awk '$1 == ".text" || $1 == ".rodata" { sum += $2 } END { print sum }')
echo "navigator: $bytes bytes of code and constants; rooms: $navigator"

build_package "$target" emulator,full
with_emulator=$(rooms "$image")
case " $with_emulator " in
*" noise "* | *" sensor "*) echo "with an error term: rooms $with_emulator" ;;
*) fail "an emulator that is used is not seen: $with_emulator" ;;
esac
