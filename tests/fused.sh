#!/usr/bin/env bash
# Looks for fused multiply-adds in the audit program's images: they round once where a product and a sum
# round twice, so that a single one could give other bits.
#   tests/fused.sh FOLDER    the images that tests/matrix.sh built
set -euo pipefail

# Arm and x86 vfma… vfms… vfnm…, AArch64 fmadd fmla…, PowerPC fmadd fnmsub…, PowerPC's vectors
# xsmadd… xvnmsub… vmaddfp vnmsubfp, z madb… mseb…, its vectors wfma… vfms….
fused='^([vw]fn?m[as]|fn?m(add|sub)|fml[as]|x[sv]n?m(add|sub)|v(madd|nmsub)fp|m[as][de]b)'
# A plain multiplication, to see that floating point is disassembled at all.
plain='^(v?mul[sp][sd]|[vf]mul|fmuls?$|xsmul|m[de]+br?$|wfmdb)'

fail() { echo "fused: $*" >&2; exit 1; }
# instructions IMAGE: the mnemonic of each.
instructions() { llvm-objdump --disassemble --no-show-raw-insn --no-leading-addr "$1" | awk '{ print $1 }'; }
# matching PATTERN IMAGE: how many instructions match.
matching() { instructions "$2" | grep -cE "$1" || true; }

for tool in llvm-objdump llvm-mc; do
    if ! command -v "$tool" >/dev/null; then
        echo "no $tool (apt-get install llvm)"
        exit 2
    fi
done

# The check itself: one fused instruction of each kind of processor, and a plain one, in an object.
object=$(mktemp)
trap 'rm -f "$object"' EXIT
while read -r triple attributes instruction; do
    llvm-mc --triple="$triple" --mattr="$attributes" --filetype=obj -o "$object" <<<"$instruction"
    [ "$(matching "$fused" "$object")" = 1 ] || fail "does not see $instruction of $triple"
done <<'END'
x86_64 +fma vfmadd231sd %xmm0, %xmm1, %xmm2
x86_64 +fma vfnmsub213ps %ymm0, %ymm1, %ymm2
thumbv7em-none-eabihf +vfp4 .fpu vfpv4-sp-d16; vfma.f32 s0, s1, s2
thumbv7em-none-eabihf +vfp4 .fpu vfpv4-sp-d16; vfnms.f32 s0, s1, s2
aarch64 +neon fmadd d0, d1, d2, d3
aarch64 +neon fmls v0.2d, v1.2d, v2.2d
s390x +vector madbr %f0, %f1, %f2
powerpc64 +vsx fmadds 0, 1, 2, 3
powerpc64 +vsx xsnmsubadp 0, 1, 2
powerpc64 +altivec vmaddfp 0, 1, 2, 3
powerpc64 +altivec vnmsubfp 0, 1, 2, 3
END
llvm-mc --triple=thumbv7em-none-eabihf --mattr=+vfp4 --filetype=obj -o "$object" <<<".fpu vfpv4-sp-d16; vmla.f32 s0, s1, s2"
[ "$(matching "$fused" "$object")" = 0 ] || fail "takes vmla.f32, which rounds twice, for fused"

images=0
for image in "$1"/*; do
    target=$(basename "$image")
    count=$(matching "$fused" "$image")
    [ "$count" = 0 ] || fail "$target holds $count fused multiply-adds"
    case $target in
    thumbv6m* | thumbv7em-none-eabi | riscv32imac* | *.wasm) ;;
    *) [ "$(matching "$plain" "$image")" -gt 100 ] || fail "no floating point is seen in $target" ;;
    esac
    images=$((images + 1))
done
[ "$images" -gt 0 ] || fail "no image in $1"
echo "no fused multiply-add in $images images"
