#!/usr/bin/env bash
# The audit program on every target of this machine: the same bits, and no fused multiply-add in any of its
# images. Installs what is missing where it can; with CI set, nothing may be missing.
#   tests/matrix.sh [OPTION …]    options of tests/src/bin/matrix: --help lists them
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/target.sh

packages=()
has() { command -v "$1" >/dev/null; }
has qemu-system-arm || packages+=(qemu-system-arm)
has qemu-aarch64 || packages+=(qemu-user)
has node || packages+=(nodejs)
[ -n "$(bare_linker)" ] || packages+=(lld)
has llvm-objdump && has llvm-mc || packages+=(llvm)
[ -x /usr/bin/rustc ] && [ -x /usr/bin/cargo ] && [ -d /usr/lib/rustlib/src/rust/library ] ||
    packages+=(rustc-web cargo-web rust-web-src)
if [ ${#packages[@]} -gt 0 ]; then install "${packages[@]}" || true; fi

tool schuler-tests matrix ${CI:+--require-all} "$@"
tests/fused.sh "${CARGO_TARGET_DIR:-target}/audit/images" || {
    if [ $? != 2 ] || [ -n "${CI:-}" ]; then exit 1; fi
    echo "skipped: instructions are not looked at"
}
