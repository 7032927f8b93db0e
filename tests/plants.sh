#!/usr/bin/env bash
# One operation of the core changed by one unit in the last place, stage by stage: `schuler audit compare`
# has to name the stage, the sample and the field. SCHULER may name the program, built already.
set -euo pipefail
cd "$(dirname "$0")/.."

schuler=${SCHULER:-cargo run --quiet --release --locked --}
builds=$(realpath -m "${CARGO_TARGET_DIR:-target}/plants")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "plants: $*" >&2; exit 1; }

navigator=f32-local-level-taylor-0-4-0

# fly FOLDER: builds the copy of the program and writes the chains of a flight.
fly() {
    (cd "$scratch/tests/audit" &&
        CARGO_TARGET_DIR="$builds" cargo build --quiet --locked --features std)
    mkdir -p "$1"
    for flight in trajectory increments noise $navigator; do
        "$builds/debug/audit" "paper/$flight" >"$1/$flight.chain"
    done
}

# plant STAGE FILE LINE REPLACEMENT EXPECTED: changes the one line of a file of core that is LINE.
plant() {
    local stage=$1 file=core/src/$2 line=$3 replacement=$4 expected=$5
    [ "$(grep -cF -- "$line" "$file")" = 1 ] || fail "$file has not just one line \"$line\""
    LINE=$line REPLACEMENT=$replacement awk \
        'index($0, ENVIRON["LINE"]) { print ENVIRON["REPLACEMENT"]; next } { print }' \
        "$file" >"$scratch/$file"
    fly "$scratch/$stage"
    cp "$file" "$scratch/$file"
    local found status=0
    $schuler audit compare "$scratch/good" "$scratch/$stage" >"$scratch/compared" 2>&1 || status=$?
    if [ "$status" != 1 ]; then
        cat "$scratch/compared"
        fail "the ulp planted in $stage is not found: status $status"
    fi
    found=$(grep '^first: ' "$scratch/compared")
    [ "$found" = "first: $expected: 1 ulp" ] || fail "planted in $stage: \"$found\", not $expected"
    echo "$found"
}

mkdir -p "$scratch/tests"
cp -r Cargo.toml README.md core "$scratch"
cp -r tests/audit tests/scenes "$scratch/tests"
# The copy is the core and the program alone.
sed -i 's#^members = .*#members = ["core", "tests/scenes"]#; /^default-members = /d' "$scratch/Cargo.toml"

fly "$scratch/good"

# x + 0.74·2⁻⁵²·x, or 2⁻²³ in single precision, rounds to the number after x.
plant trajectory trajectory/harmonic.rs '*x = *x + in_phase;' \
    '*x = *x + in_phase; if P::any(P::of(30.0).less(time_s.hi)) && share.channel == 5 { *x = *x + *x * P::of(1.64e-16); }' \
    "trajectory, sample 601, stage trajectory, field altitude value"
plant increments imu.rs 'angle_b: sum.rate_ib_b * time + sum.rate_ib_b * low,' \
    'angle_b: {
         let mut angle_b = sum.rate_ib_b * time + sum.rate_ib_b * low;
         if R::any(R::of(45.01).less(centre_s.hi)) { angle_b.y = angle_b.y + angle_b.y * R::of(1.64e-16); }
         angle_b
     },' \
    "increments, sample 901, stage increments, field angle_b y"
plant noise sensor/white.rs 'reading.increment = reading.increment + noise;' \
    'reading.increment = reading.increment + noise;
     reading.increment.z = reading.increment.z + reading.increment.z * R::of(1.64e-16);' \
    "noise, sample 1, stage noise, field angle_b z"
plant body strapdown/block/body.rs 'let motion = BodyMotion {' \
    'let velocity = Vector { x: velocity.x + velocity.x * R::of(8.8e-8), ..velocity };
     let motion = BodyMotion {' \
    "$navigator, sample 4, stage body, field velocity x"
plant nav strapdown/frame/local_level.rs '// Into the axes at the end: v ← q* v, q_b ← q* ⊗ q_b ⊗ q_bb' \
    'self.gravity_excess = self.gravity_excess + self.gravity_excess * R::of(8.8e-8);' \
    "$navigator, sample 4, stage nav, field gravity_excess"

# A line more in the table of windows is a navigator more in every precision and axes.
windows=core/src/strapdown/block/window.rs
awk '/^    H4B4A4 = / { print "    H1B4A1 = 1, 4, 1, through 6, 14, audited;"; print "    /// After the planted one." } { print }' \
    "$windows" >"$scratch/$windows"
(cd "$scratch/tests/audit" && CARGO_TARGET_DIR="$builds" cargo build --quiet --locked --features std)
cp "$windows" "$scratch/$windows"
found=$("$builds/debug/audit" | sed -n 's|^paper/\([a-z0-9-]*\)-taylor-1-4-1 nav =.*|\1|p' | sort)
[ "$(wc -w <<<"$found")" = 6 ] || fail "a planted window is found in: $found"
echo "a window planted in one line is flown by:" $found
