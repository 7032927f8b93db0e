# Building core for a target without an operating system, with whichever compiler knows the target:
# rustup's, or else Debian's, which brings the sources of `core`.

target=thumbv7em-none-eabihf

# The linker of targets without an operating system: rustup's own, or Debian's.
bare_linker() {
    local own
    own=$(rustc --print sysroot 2>/dev/null)/lib/rustlib/x86_64-unknown-linux-gnu/bin/rust-lld
    if [ -x "$own" ]; then echo "$own"; else command -v ld.lld; fi
}

# install PACKAGE …: Debian's, as far as this machine lets us. Two stages at a time may ask for some.
install() {
    command -v apt-get >/dev/null && [ "$(id -u)" = 0 ] || return 1
    (
        flock 9
        apt-get update -qq >/dev/null && apt-get install -y -qq --no-install-recommends "$@" >/dev/null
    ) 9>"${TMPDIR:-/tmp}/schuler-install.lock"
}

# Prepares the compiler for a target.
prepare_target() {
    if rustc --print target-libdir --target "$target" 2>/dev/null | xargs -r test -d 2>/dev/null; then
        return
    fi
    if command -v rustup >/dev/null && timeout 60 rustup target add "$target" >/dev/null 2>&1; then
        return
    fi
    if [ ! -x /usr/bin/cargo ]; then install rustc-web cargo-web rust-web-src lld; fi
}

# skip_without_compiler STATUS: ends what cannot go on; without CI a missing compiler is said and passed over.
skip_without_compiler() {
    if [ "$1" != $no_compiler ] || [ -n "${CI:-}" ]; then exit 1; fi
    echo "skipped: no compiler for $target (rustup target add $target)"
}

# build_core TARGET FEATURES [OPTION …]
build_core() { build_package "$1" "$2" --package schuler --no-default-features "${@:3}"; }

# What the builders below return where no compiler knows the target; otherwise it is cargo's own status.
no_compiler=3

# build_package TARGET FEATURES [OPTION …]: the package of this directory. The variable cargo_command may
# hold another command than a release build.
build_package() {
    target=$1
    prepare_target || true
    local arguments=(${cargo_command:-build --release} --locked --target "$target" --features "$2" "${@:3}")
    if rustc --print target-libdir --target "$target" 2>/dev/null | xargs -r test -d; then
        cargo "${arguments[@]}"
    elif [ -x /usr/bin/cargo ] && [ -x /usr/bin/rustc ]; then
        local linker
        linker=CARGO_TARGET_$(tr 'a-z.-' 'A-Z__' <<<"$target")_LINKER
        env "$linker=$(bare_linker)" RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 \
            /usr/bin/cargo "${arguments[@]}" -Z build-std=core
    else
        return $no_compiler
    fi
}

# build_program: builds the program, unless SCHULER names one that is built already, and sets SCHULER. The wheel of
# host/python asks other people's crates for more features than the program does: with these, both share what is compiled.
build_program() {
    if [ -n "${SCHULER:-}" ]; then return; fi
    cargo build --release --locked --quiet --package schuler-host --package schuler-python \
        --features schuler-python/module --bin schuler
    SCHULER=$(realpath -m "${CARGO_TARGET_DIR:-target}")/release/schuler
    export SCHULER
}

# tool PACKAGE NAME [ARGUMENT …]: a program of the tests, as tests/run has built it beside the tests; else it
# is built. Alone it takes other features of other people's crates, and with them another build of the host.
tool() {
    if [ -n "${SCHULER_TOOLS:-}" ]; then
        "$SCHULER_TOOLS/$2" "${@:3}"
    else
        cargo run --quiet --locked --package "$1" --bin "$2" -- "${@:3}"
    fi
}
