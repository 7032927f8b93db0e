#!/usr/bin/env bash
# Builds the firmware for every target, flies it in QEMU, and holds it against the program on this
# machine and against the table of costs.
#   tests/firmware.sh           compares with tests/firmware/BUDGET.md
#   tests/firmware.sh --store   writes what is measured in its place
# Without QEMU or a compiler it skips with a line that says so; with CI set it installs them.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/target.sh

has_qemu() { command -v qemu-system-arm >/dev/null && command -v qemu-system-riscv32 >/dev/null; }

if ! has_qemu && [ -n "${CI:-}" ]; then
    install qemu-system-arm qemu-system-misc
fi
if ! has_qemu; then
    echo "skipped: no QEMU (apt-get install qemu-system-arm qemu-system-misc)"
    exit 0
fi

runner() { tool schuler-qemu schuler-qemu "$@"; }

images=$(realpath -m "${CARGO_TARGET_DIR:-tests/firmware/target}")
build_program
builds=$(runner builds)
while read -r triple board; do
    bins=(--bin selftest --bin budget --bin single --bin single-planned --bin navigator-f32)
    # The image that `schuler hil` looks for: every mechanization, f64 in software among them. Aided flights. And
    # paths that are compiled on the target, in f64 too.
    if [ "$board $triple" = "mps2 thumbv7em-none-eabihf" ]; then
        bins+=(--bin navigator --bin navigator-aided --bin circuit)
    fi
    # An aided flight does not fit the RAM of a micro:bit.
    if [ "$board" != microbit ]; then bins+=(--bin aiding); fi
    status=0
    (cd tests/firmware &&
        build_package "$triple" "$board,semihosting" --no-default-features --quiet "${bins[@]}") ||
        status=$?
    if [ "$status" != 0 ]; then
        target=$triple
        skip_without_compiler "$status"
        exit 0
    fi
done <<<"$builds"

# The images for a board behind a debug probe fly nowhere here: they are looked at.
lint() {
    (cd tests/firmware &&
        cargo clippy --release --locked --quiet --target thumbv7em-none-eabihf \
            --no-default-features --features "$1" "${@:2}" -- -D warnings)
}
if rustc --print target-libdir --target thumbv7em-none-eabihf 2>/dev/null | xargs -r test -d &&
    cargo clippy --version >/dev/null 2>&1; then
    lint mps2,semihosting --bins
    lint mps2,rtt,dwt --bin selftest --bin budget --bin aiding
else
    echo "skipped: clippy over the firmware (rustup target add thumbv7em-none-eabihf)"
fi
runner check "$@" "$images" "$SCHULER" tests/firmware/BUDGET.md
