#!/usr/bin/env bash
# The C library: its header under every compiler, its symbols and sizes, misuse under sanitizers, one digest on a desktop, a
# Cortex-M4F and a Cortex-M0, a port audited against the golden chains, a target for `schuler hil`, and the packages.
#   tests/c.sh           compares sizes with host/c/BUDGET.md
#   tests/c.sh --store   writes them in its place
# What this machine lacks is named, and its part is passed over; with CI set nothing may be missing. SCHULER may name the
# program, built already.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/target.sh

say() { printf '%s\n' "c: $*"; }
fail() { echo "c: $*" >&2; exit 1; }
has() { command -v "$1" >/dev/null; }

packages=()
has gcc && has g++ || packages+=(gcc g++)
has clang || packages+=(clang)
# Its sanitizers come in a package of its version.
sanitizes() { "$1" -x c -fsanitize=address,undefined -o /dev/null - <<<'int main(void) { return 0; }' 2>/dev/null; }
has clang && sanitizes clang || packages+=(libclang-rt-dev)
has cmake || packages+=(cmake)
has pkg-config || packages+=(pkg-config)
has arm-none-eabi-gcc || packages+=(gcc-arm-none-eabi libnewlib-arm-none-eabi)
has qemu-system-arm || packages+=(qemu-system-arm)
if [ ${#packages[@]} -gt 0 ] && [ -n "${CI:-}" ]; then install "${packages[@]}"; fi

# lacks TOOL PART: whether a part has to be passed over.
lacks() {
    if has "$1"; then return 1; fi
    if [ -n "${CI:-}" ]; then fail "$1 is missing, for $2"; fi
    say "skipped: $2 ($1 is missing: apt-get install ${packages[*]})"
}

out=$(realpath -m "${CARGO_TARGET_DIR:-target}")/c-library
examples=host/c/examples
mkdir -p "$out"
build_program

warnings=(-Wall -Wextra -Werror -pedantic)
c99=(-std=c99 "${warnings[@]}" -O2 -ffp-contract=off -Ihost/c/include)
cpp17=(-std=c++17 "${warnings[@]}" -O2 -ffp-contract=off -Ihost/c/include)

compilers=()
for pair in gcc:g++ clang:clang++; do
    lacks "${pair%:*}" "everything built by ${pair%:*}" || compilers+=("$pair")
done

[ ${#compilers[@]} -gt 0 ] || exit 0

# What flies everywhere: perfect increments and initial solutions of the golden flights, as bits.
"$SCHULER" audit record paper --duration 60 --configuration f64-local-level-textbook --out "$out/chains" >/dev/null
"$SCHULER" audit record tests/golden/turns.toml --configuration f64-local-level-textbook --out "$out/chains" >/dev/null
# flight SCENE STAGE: its part of flights.h, with the samples of a stage.
flight() {
    local upper=${1^^}
    awk -v name="$1" -v upper="$upper" -v stage="$2" '
        $1 == stage && $2 ~ /^[0-9]+$/ {
            line = ""
            for (i = 3; i <= 8; i++) line = line sprintf("UINT64_C(0x%s), ", $i)
            rows = rows sprintf("    { %s},\n", line)
            count++
        }
        END { printf "#define %s_SAMPLES %dU\nstatic const uint64_t %s_increments[%d][6] = {\n%s};\n", upper, count, name, count, rows }
    ' "$out/chains/$1/$2.chain"
    awk -v name="$1" '
        $1 == "initial:" {
            line = ""
            for (i = 2; i <= 21; i++) line = line sprintf("UINT64_C(0x%s), ", $i)
            printf "static const uint64_t %s_initial[20] = { %s};\n", name, line
        }
    ' "$out/chains/$1/f64-local-level-textbook.chain"
}
# The small target has room for one flight, and none for the sensors.
for stage in increments noise; do
    for flights in paper turns both; do
        mkdir -p "$out/flights/$stage/$flights"
        for scene in paper turns; do
            if [ "$flights" = both ] || [ "$flights" = "$scene" ]; then flight "$scene" $stage; fi
        done >"$out/flights/$stage/$flights/flights.h"
    done
done
# What the digests have to be.
for scene in paper turns; do
    for chain in tests/golden/$scene/*.chain; do
        stem=$(basename "$chain" .chain)
        case $stem in
        noise) sed -n "s/^noise = [0-9]* /$scene noise /p" "$chain" ;;
        *-textbook | *-taylor-0-4-0) sed -n "s/^nav = [0-9]* /$scene $stem /p" "$chain" ;;
        esac
    done
done | sort >"$out/golden.txt"
# digests WHERE FILE COUNT: whether a program has said so many digests, each a golden one.
digests() {
    local wrong
    tr -d '\r' <"$2" | sort >"$2.sorted"
    [ "$(wc -l <"$2.sorted")" = "$3" ] || fail "$1: $(wc -l <"$2.sorted") digests, not $3: $(cat "$2.sorted")"
    wrong=$(comm -23 "$2.sorted" "$out/golden.txt")
    [ -z "$wrong" ] || fail "$1: not the golden digests: $wrong"
    say "$1: $3 digests, all of them golden"
}

# symbols ARCHIVE NM: nothing that panics, allocates or unwinds.
symbols() {
    local found
    found=$("$2" "$1" 2>/dev/null | grep -E ' [TtUWwRrDdBb] ' |
        grep -E 'panicking|core..fmt|slice_index_fail|unwrap_failed|__rust_alloc|rust_eh|_Unwind| (malloc|free|calloc|realloc)$' || true)
    # The handler itself is there, and nothing calls it.
    [ -z "$found" ] || fail "$1: $found"
}

CARGO_PROFILE_C_OPT_LEVEL=3 host/c/archive.sh "$out/libschuler.a"
symbols "$out/libschuler.a" nm
say "libschuler.a: $(stat -c %s "$out/libschuler.a") bytes, no panic, no heap"

for pair in "${compilers[@]}"; do
    cc=${pair%:*} cxx=${pair#*:}
    at=$out/$cc
    mkdir -p "$at"
    # The header alone, in both languages.
    for language in c c++; do
        standard=c99
        if [ $language = c++ ]; then standard=c++17; fi
        echo '#include "schuler.h"' | "$cc" -x $language -std=$standard "${warnings[@]}" -Wstrict-overflow -Wshadow \
            -Ihost/c/include -fsyntax-only -
    done
    "$cc" "${c99[@]}" $examples/desktop/desktop.c "$out/libschuler.a" -lm -o "$at/desktop"
    "$at/desktop"
    "$cc" "${c99[@]}" -I"$out/flights/increments/both" $examples/digests/*.c "$out/libschuler.a" -o "$at/digests"
    "$at/digests" >"$at/digests.txt"
    digests "$cc on $(uname -m)" "$at/digests.txt" 14
    "$cxx" "${cpp17[@]}" $examples/cpp/flight.cpp "$out/libschuler.a" -o "$at/flight"
    "$at/flight"
    # C++ flies the same files.
    "$cxx" "${cpp17[@]}" -I"$out/flights/increments/both" $examples/cpp/digests.cpp "$out/libschuler.a" -o "$at/digests-cpp"
    "$at/digests-cpp" >"$at/digests-cpp.txt"
    digests "$cxx on $(uname -m)" "$at/digests-cpp.txt" 4
    if sanitizes "$cc"; then
        "$cc" "${c99[@]}" -g -fsanitize=address,undefined -fno-sanitize-recover=all host/c/tests/misuse.c \
            "$out/libschuler.a" -lm -o "$at/misuse"
        "$at/misuse"
    elif [ -n "${CI:-}" ]; then
        fail "$cc has no sanitizers (libclang-rt-dev)"
    else
        say "skipped: misuse under $cc's sanitizers (apt-get install libclang-rt-dev)"
    fi

    # The port by hand: first with its fault, which the audit has to name, then without. Where the compiler may
    # reorder sums, the bits differ, but no number by much.
    port=($examples/textbook/textbook.c $examples/textbook/mechanization.c)
    "$cc" "${c99[@]}" -DPLANTED "${port[@]}" -lm -o "$at/textbook-planted"
    "$cc" "${c99[@]}" "${port[@]}" -lm -o "$at/textbook"
    "$cc" "${c99[@]}" -ffast-math "${port[@]}" -lm -o "$at/textbook-fast"
    for scene in paper turns; do
        chains=$out/chains/$scene
        golden=tests/golden/$scene/f64-local-level-textbook.chain
        for kind in -planted -fast ""; do
            "$at/textbook$kind" "$chains/noise.chain" $golden >"$at/mine$kind.chain"
        done
        # compared EXIT CHAIN [OPTION …]: what the audit says.
        compared() {
            local status=0
            "$SCHULER" audit compare $golden "$at/$2.chain" "${@:3}" >"$at/compared.txt" || status=$?
            [ "$status" = "$1" ] || fail "audit compare $scene/$2 ${*:3}: exit $status, not $1: $(cat "$at/compared.txt")"
        }
        compared 1 mine-planted
        grep -q "sample 2, stage body, field rotation x" "$at/compared.txt" ||
            fail "the planted fault is not named: $(cat "$at/compared.txt")"
        say "planted in the port, $scene: $(sed -n 2p "$at/compared.txt" | sed 's/^ *//')"
        limits=(--within 1e-11 --ulps rotation=4)
        compared 1 mine-planted "${limits[@]}"
        grep -q "first stage body, field rotation x, from sample 2 on" "$at/compared.txt" ||
            fail "the planted fault is not named within limits: $(cat "$at/compared.txt")"
        compared 1 mine-fast --ulps 0
        compared 0 mine-fast "${limits[@]}"
        compared 0 mine
        say "the port, $scene: $(head -1 "$at/compared.txt")"
        "$SCHULER" audit compare "$chains/f64-local-level-textbook.chain" "$at/mine.chain" >"$at/compared.txt" ||
            fail "the port parts: $(cat "$at/compared.txt")"
        # A chain of another flight is told by its head, before anything else.
        sed "s/^seed: .*/seed: 7/" "$at/mine.chain" >"$at/other.chain"
        compared 0 other
        [ "$(head -1 "$at/compared.txt")" = "the heads contradict each other: seed is 1 in the one, 7 in the other" ] ||
            fail "another seed is not named: $(cat "$at/compared.txt")"
    done
    "$cc" "${c99[@]}" $examples/textbook/functions.c $examples/textbook/mechanization.c -lm -o "$at/functions"
    "$at/functions" tests/golden/functions/*.txt

    # The application of a target, on a port.
    "$cc" "${c99[@]}" $examples/hil/hil.c "$out/libschuler.a" -o "$at/hil"
done

at=$out/${compilers[0]%:*}
for flight in "paper --precision f32" "paper --frame earth-fixed" "paper --algorithm textbook"; do
    : >"$at/hil.port"
    "$at/hil" 0 >"$at/hil.port" &
    target=$!
    for _ in $(seq 100); do [ -s "$at/hil.port" ] && break || sleep 0.05; done
    # shellcheck disable=SC2086
    "$SCHULER" hil $flight --duration 20 --no-report --out "$at/hil-out" --device "$(cat "$at/hil.port")" \
        >"$at/hil.txt" || fail "schuler hil $flight: $(cat "$at/hil.txt")"
    wait "$target" || true
    say "hil $flight: the C target keeps step with the host"
done

# README's ten lines.
awk '/^```c$/ { inside = 1; next } /^```$/ { inside = 0 } inside' README.md >"$out/readme.c"
[ -s "$out/readme.c" ] || fail "README.md has no C"
for pair in "${compilers[@]}"; do
    "${pair%:*}" "${c99[@]}" "$out/readme.c" "$out/libschuler.a" -o "$out/readme" && "$out/readme"
done

lacks cmake "the CMake package" || {
    rm -rf "$out/cmake" "$out/prefix"
    cmake -S host/c -B "$out/cmake/library" -DSCHULER_ARCHIVE="$out/libschuler.a" -DCMAKE_INSTALL_PREFIX="$out/prefix" \
        -DCMAKE_INSTALL_LIBDIR=lib >/dev/null
    cmake --build "$out/cmake/library" >/dev/null
    cmake --install "$out/cmake/library" >/dev/null
    cmake -S $examples/package -B "$out/cmake/user" -DCMAKE_PREFIX_PATH="$out/prefix" >/dev/null
    cmake --build "$out/cmake/user" >/dev/null
    "$out/cmake/user/desktop" >/dev/null
    "$out/cmake/user/flight" >/dev/null
    say "find_package(Schuler): found, built and run"
    lacks pkg-config "the pkg-config file" || {
        read -ra flags < <(PKG_CONFIG_PATH=$out/prefix/lib/pkgconfig pkg-config --cflags --libs schuler)
        ${compilers[0]%:*} -std=c99 "$out/readme.c" "${flags[@]}" -o "$out/readme-pkg" && "$out/readme-pkg"
        say "pkg-config: found, built and run"
    }
}

if lacks arm-none-eabi-gcc "bare metal" || lacks qemu-system-arm "bare metal"; then exit 0; fi
m4f=(-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16)
m0=(-mcpu=cortex-m0 -mthumb -mfloat-abi=soft)
# image FOLDER CPU... -- SOURCE...: links an image from C sources and the archive of FOLDER.
bare=(-std=c99 "${warnings[@]}" -Os -ffp-contract=off -ffreestanding -ffunction-sections -fdata-sections -Ihost/c/include
    -L$examples/bare -nostartfiles --specs=nosys.specs -Wl,--gc-sections -Wl,-z,noexecstack)
# run MACHINE IMAGE: what an image says.
run() {
    timeout 600 qemu-system-arm -machine "$1" -display none -monitor none -serial none \
        -semihosting-config enable=on,target=native,chardev=said -chardev stdio,id=said -kernel "$2"
}
for board in m4f:thumbv7em-none-eabihf:mps2-an386:increments: m0:thumbv6m-none-eabi:microbit:noise:-DMEASURED; do
    IFS=: read -r name triple machine stage measured <<<"$board"
    at=$out/$name
    mkdir -p "$at"
    status=0
    CARGO_PROFILE_C_OPT_LEVEL=s host/c/archive.sh "$at/libschuler.a" $triple || status=$?
    if [ "$status" != 0 ]; then
        target=$triple
        skip_without_compiler "$status"
        continue
    fi
    symbols "$at/libschuler.a" arm-none-eabi-nm
    declare -n cpu=$name
    : >"$at/digests.txt"
    for scene in paper turns; do
        arm-none-eabi-gcc "${cpu[@]}" "${bare[@]}" -T $name.ld $measured -I"$out/flights/$stage/$scene" $examples/digests/digests.c \
            $examples/bare/*.c "$at/libschuler.a" -o "$at/digests-$scene.elf"
        run $machine "$at/digests-$scene.elf" >>"$at/digests.txt" || fail "$name, $scene: $(tail -3 "$at/digests.txt")"
    done
    digests "C on $name in QEMU's $machine" "$at/digests.txt" 14
done

[ -e "$out/m4f/libschuler.a" ] || exit 0
arm-none-eabi-gcc "${m4f[@]}" "${bare[@]}" -T m4f.ld $examples/hil/mps2.c $examples/bare/startup.c \
    "$out/m4f/libschuler.a" -o "$out/m4f/hil.elf"
"$SCHULER" hil paper --precision f32 --duration 20 --no-report --out "$out/m4f/hil-out" --device qemu \
    --image "$out/m4f/hil.elf" >"$out/m4f/hil.txt" || fail "hil on the M4F: $(cat "$out/m4f/hil.txt")"
say "hil paper --precision f32: the C target on a Cortex-M4F keeps step with the host"

# weigh TARGET SYMBOL...: bytes of code and constants of some functions with everything that they call. The image stays.
weigh() {
    local keep=() symbol
    declare -n cpu_of=$1
    for symbol in "${@:2}"; do keep+=("-Wl,-u,$symbol"); done
    arm-none-eabi-gcc "${cpu_of[@]}" -nostdlib -Wl,--gc-sections -Wl,-e,"$2" "${keep[@]}" "$out/$1/libschuler.a" \
        -Wl,-z,noexecstack -lgcc -o "$out/$1/weighed.elf"
    arm-none-eabi-size -A "$out/$1/weighed.elf" |
        awk '$1 == ".text" || $1 == ".rodata" { sum += $2 } END { print sum + 0 }'
}
# largest TARGET: bytes of the largest function of the image that was weighed.
largest() {
    local size
    size=$(arm-none-eabi-nm --size-sort -S "$out/$1/weighed.elf" | awk '$3 ~ /[tTwW]/ { size = $2 } END { print size }')
    echo $((16#$size))
}
budget() {
    cat <<'END'
# What the C library costs on a target

`tests/c.sh` measures this and fails where a budget is exceeded or a number has moved by more than 2 %;
`tests/c.sh --store` writes it anew. The archive is built for size (`opt-level = "s"`).

A state is the C type's size, on every target. "push" is `_push` with everything that is called on the way: the step, the
first block's gravity history, libm, and copying memory, which a C library has, too. "step" is the largest function of that:
the step itself, everything inlined (with `_any` it is in pieces). "all" is every function of the navigator. On a Cortex-M0
arithmetic in software is in each but "step". Budgets, for `f32_local_level_h0b4a0`: state ≤ 512 bytes, step on a Cortex-M4F
≤ 9216 bytes.

| navigator | state | stored | M4F: step | push | start | all | M0: step | push | start | all |
|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
END
    sed -n 's/^SCHULER_NAVIGATOR[A-Z_]*(\([a-z0-9_]*\), .*/\1/p' host/c/include/schuler.hpp | while read -r navigator; do
        upper=${navigator^^}
        words=$(grep -B1 "^} schuler_$navigator;" host/c/include/schuler.h | sed -n 's/.*opaque\[\([0-9]*\)\].*/\1/p')
        stored=$(sed -n "s/^#define SCHULER_${upper}_SAVED //p" host/c/include/schuler.h)
        row="| \`$navigator\` | $((8 * words)) | $stored |"
        mapfile -t all < <(grep -o "schuler_${navigator}_[a-z_]*(" host/c/include/schuler.h | tr -d '(' |
            grep -v "schuler_${navigator}_any_" | sort -u)
        for core in m4f m0; do
            push=$(weigh $core "schuler_${navigator}_push")
            row+=" $(largest $core) | $push | $(weigh $core "schuler_${navigator}_start") | $(weigh $core "${all[@]}") |"
        done
        echo "$row"
    done
    echo
    echo "Archives, stripped, with all navigators: $(stat -c %s "$out/m4f/libschuler.a") bytes (M4F), $(stat -c %s "$out/m0/libschuler.a") (M0)."
}
[ -e "$out/m0/libschuler.a" ] || exit 0
budget >"$out/BUDGET.md"
read -r state step < <(awk -F'|' '/^. `f32_local_level_h0b4a0` / { print $3, $5 }' "$out/BUDGET.md")
[ "$state" -le 512 ] && [ "$step" -le 9216 ] || fail "f32: state $state bytes, step $step"
if [ "${1:-}" = --store ]; then
    cp "$out/BUDGET.md" host/c/BUDGET.md
else
    # Numbers may move by 2 %; everything else is the same.
    moved=$(paste -d'\n' host/c/BUDGET.md "$out/BUDGET.md" | awk '
        NR % 2 { stored = $0; next }
        {
            n = split(stored, a, /[ |]+/); m = split($0, b, /[ |]+/)
            differs = n != m
            for (i = 1; i <= n && !differs; i++) {
                number = a[i] ~ /^[0-9]+$/ && b[i] ~ /^[0-9]+$/
                differs = number ? (b[i] > a[i] * 1.02 || b[i] < a[i] * 0.98) : a[i] != b[i]
            }
            if (differs) { print "stored: " stored; print "now:    " $0 }
        }')
    [ -z "$moved" ] || fail "sizes have moved (--store writes them):
$moved"
fi
say "f32_local_level_h0b4a0 on a Cortex-M4F: state $state bytes, step $step bytes"
