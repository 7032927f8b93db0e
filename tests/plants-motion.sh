#!/usr/bin/env bash
# Faults in how paths are made and sampled, one line of core each: the program `floor`, which flies built-in
# paths, has to find every one. It prints how far each leads astray.
set -euo pipefail
cd "$(dirname "$0")/.."

builds=$(realpath -m "${CARGO_TARGET_DIR:-target}/plants-motion")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "plants-motion: $*" >&2; exit 1; }

mkdir -p "$scratch/tests"
cp -r Cargo.toml Cargo.lock README.md core "$scratch"
cp -r tests/scenes "$scratch/tests"
# The copy is the core and its scenes alone.
sed -i 's#^members = .*#members = ["core", "tests/scenes"]#; /^default-members = /d' "$scratch/Cargo.toml"

# fly FILE: builds the copy and writes what its flights come to; the status is the program's.
fly() {
    (cd "$scratch" && CARGO_TARGET_DIR="$builds" RUSTFLAGS=--cap-lints=allow \
        cargo build --quiet --package schuler-scenes --bin floor)
    "$builds/debug/floor" >"$1"
}

# plant NAME FILE LINE REPLACEMENT FLIGHT…: changes the one line of a file of core's trajectories that is LINE; at
# least the flights named have to be off.
plant() {
    local name=$1 file=core/src/$2 line=$3 replacement=$4 status=0 flight
    [ "$(grep -cF -- "$line" "$file")" = 1 ] || fail "$file has not just one line \"$line\""
    LINE=$line REPLACEMENT=$replacement awk \
        'index($0, ENVIRON["LINE"]) { print ENVIRON["REPLACEMENT"]; next } { print }' \
        "$file" >"$scratch/$file"
    fly "$scratch/found" || status=$?
    cp "$file" "$scratch/$file"
    # A build that fails is no find.
    [ "$status" = 1 ] && [ -s "$scratch/found" ] || fail "$name is not found: status $status"
    for flight in "${@:5}"; do
        grep -E "^$flight.*(too far|refused)" "$scratch/found" >/dev/null ||
            { cat "$scratch/found"; fail "$name: $flight is not off"; }
    done
    table+=("$(printf '%-42s' "$name")$(cut -c 25- "$scratch/found" | tr '\n' '|' | sed 's/ *|/   /g')")
    rm "$scratch/found"
}

fly "$scratch/good" || { cat "$scratch/good"; fail "without a fault the flights are off"; }
cat "$scratch/good"
table=()

plant "quadrature not split at joints" imu.rs \
    'Some(joint_s) if is_within(joint_s) => self.in_parts(trajectory, centre_s, interval_s),' \
    'Some(joint_s) if is_within(joint_s) => self.unbroken(trajectory, centre_s, interval_s),' \
    "across a joint"
plant "a blend with two derivatives" trajectory/segment/step.rs 'let power = square * square * square;' \
    'let power = square.scaled(30.0 / 12012.0);
     fn head(x: f64) -> f64 { x * x * x * (10.0 + x * (6.0 * x - 15.0)) }' \
    circuit
plant "cubic pieces" trajectory/segment/flyer.rs 'let coefficients = two_point(start, end, half);' \
    'let [[a, a1, ..], [b, b1, ..]] = [start, end];
     let [quarter, three_quarters] = [0.25, 0.75].map(Pair::new);
     let (inverse, sum, bend) = (half.reciprocal(), *a1 + *b1, (*b1 - *a1) * quarter);
     let slope = (*b - *a) * inverse;
     let mut coefficients = [Pair::default(); TERMS];
     if let [c0, c1, c2, c3, ..] = &mut coefficients {
         *c0 = (*a + *b) * Pair::new(0.5) - bend * half;
         *c1 = slope * three_quarters - sum * quarter;
         *c2 = bend * inverse;
         *c3 = (sum - slope) * quarter * inverse * inverse;
     }' \
    circuit
plant "no 2Ω×v" trajectory/kinematics.rs 'acceleration_e + earth_cross(velocity_e) * 2.0 + gravity_e' \
    'acceleration_e + gravity_e' \
    circuit
plant "no 2Ω×v, attitude by a rule" trajectory/piecewise/axes.rs \
    'force.y = force.y + v.x.scaled(2.0 * ROTATION_RATE);' '' \
    waypoints
plant "γ̇ left out" trajectory/piecewise/axes.rs 'let mut force = acceleration + normal * place.gravity();' \
    'let mut force = acceleration + normal * Series::constant(place.gravity::<M>().value());' \
    waypoints
plant "a quaternion's sign flipped" trajectory/segment/flyer.rs 's = s.map(|series| -series);' '' \
    circuit
# A conversion in plain f64 shows in no flight at this bound: `the_conversion_has_twice_the_digits` in
# tests/paths/spline.rs fails with it.

echo
printf '%-42s%s\n' "planted" "found, in the order of the flights above"
printf '%s\n' "${table[@]}"
