#!/usr/bin/env bash
# Core builds with the oldest compiler that its Cargo.toml promises. Where rustup has not got it, what newer
# compilers' libraries brought is refused by clippy::incompatible_msrv alone; a line says which it was.
#   tests/oldest.sh
set -euo pipefail
cd "$(dirname "$0")/.."

oldest=$(sed -n 's/^rust-version = "\(.*\)"$/\1/p' core/Cargo.toml)
[ -n "$oldest" ] || { echo "oldest: core/Cargo.toml has no rust-version" >&2; exit 1; }
toolchain=$(rustup toolchain list 2>/dev/null | grep -om1 "^$oldest[.0-9]*-[^ ]*" || true)
if [ -z "$toolchain" ]; then
    echo "Rust $oldest is not installed: clippy::incompatible_msrv looked (rustup toolchain install $oldest)"
    exit 0
fi
# A folder of its own: what the usual compiler has built stays.
CARGO_TARGET_DIR="$(realpath -m "${CARGO_TARGET_DIR:-target}")/oldest" cargo "+$toolchain" check --quiet --locked \
    --package schuler --features full,micromath,defmt
echo "core builds with Rust $oldest"
