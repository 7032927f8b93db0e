#!/usr/bin/env bash
# Builds the C library for a target of rustc, this machine's if none is named, and strips it of debugging information.
#   host/c/archive.sh libschuler.a [TARGET]
# For size say CARGO_PROFILE_C_OPT_LEVEL=s. Without rustup's target it takes Debian's compiler, as tests/target.sh does.
set -euo pipefail
to=$(realpath -m "$1")
cd "$(dirname "$0")/../.."
. tests/target.sh

host=$(rustc -vV | sed -n 's/^host: //p')
triple=${2:-$host}
built=$(realpath -m "${CARGO_TARGET_DIR:-target}")/$triple/c/libschuler_c.a
status=0
cargo_command="rustc --quiet --profile c --crate-type staticlib --lib" \
    build_package "$triple" archive --package schuler-c || status=$?
if [ "$status" != 0 ]; then exit "$status"; fi
mkdir -p "$(dirname "$to")"
# Either knows every target that Rust has; a compiler's own strip knows its target alone.
strip=$(command -v llvm-strip || ls /usr/bin/llvm-strip-* 2>/dev/null | tail -1 || true)
case $triple in
thumb*) strip=${strip:-arm-none-eabi-strip} ;;
*) strip=${strip:-strip} ;;
esac
cp "$built" "$to"
if command -v "$strip" >/dev/null; then
    "$strip" --strip-debug "$to"
else
    echo "archive: not stripped ($strip is missing)" >&2
fi
