//! libm's functions, through the core's scalar: the bits that the golden chains were flown with.

use schuler_host::audit::functions;
use std::path::Path;

#[test]
fn libm_has_the_golden_bits() {
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden");
    let verdicts = functions::verify(&golden).unwrap().expect("tests/golden/functions.txt");
    assert_eq!(verdicts.len(), 12);
    let differing: Vec<_> = verdicts.iter().filter(|verdict| !verdict.holds()).collect();
    assert!(differing.is_empty(), "another libm than the golden chains': {differing:?}");
}
