//! The reference of all keys is the parser's own table.

use super::scene;
use schuler_simulator::scene::keys;
use std::path::Path;

/// `schuler scenes --keys > host/KEYS.md` writes it anew.
#[test]
fn the_reference_is_up_to_date() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../KEYS.md");
    let text = std::fs::read_to_string(file).expect("it is in the repository");
    assert!(text == keys::reference(), "host/KEYS.md is not what `schuler scenes --keys` prints");
}

/// A key that is told is accepted, and one that is not is refused with those that are.
#[test]
fn the_parser_knows_the_keys_of_the_reference() {
    let tables = [
        (&keys::general::LINK, "link"),
        (&keys::general::NAVIGATOR, "navigator"),
        (&keys::motion::VIBRATION, "trajectory.vibration"),
        (&keys::path::START, "trajectory.start"),
        (&keys::path::WAYPOINTS, "trajectory.waypoints"),
        (&keys::path::LOG, "trajectory.log"),
        (&keys::motion::TRAJECTORY, "trajectory"),
    ];
    for (table, name) in tables {
        let error = scene(&format!("[{name}]\nno_such_key = 1\n")).expect_err(name).to_string();
        assert!(error.contains(&format!("{name}.no_such_key: is not a key")), "{error}");
        assert!(error.ends_with(&table.names().join(", ")), "{error}");
        for key in table.keys {
            // Of a type that no key takes: it is refused for that, not for its name.
            let text = format!("[{name}]\n{} = 1979-05-27\n", key.name);
            let error = scene(&text).expect_err(key.name).to_string();
            assert!(!error.contains("is not a key of"), "{error}");
        }
    }
}
