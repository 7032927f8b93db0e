//! `schuler audit`: golden chains, a planted bit, and what one unit in the last place does.

use schuler_host::audit::chain::Chain;
use schuler_host::audit::compare::compare;
use schuler_host::audit::configuration::ALL;
use schuler_host::audit::record::{Cadence, record};
use schuler_host::audit::{golden, sensitivity};
use schuler_host::scene::{Precision, builtin};
use std::path::Path;
use std::process::{Command, Output};

fn golden_folder() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/golden"))
}

fn schuler(arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_schuler");
    Command::new(program).arg("audit").args(arguments).output().unwrap()
}

fn printed(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

#[test]
fn this_build_has_the_golden_bits() {
    let verdicts = golden::verify(golden_folder(), &mut |_| Ok(())).unwrap();
    // Two scenes: three stages that all share, and every navigator.
    assert_eq!(verdicts.len(), 2 * (3 + ALL.len()));
    for verdict in verdicts {
        assert_eq!(verdict.parting, None, "{}", verdict.chain);
    }
}

#[test]
fn a_planted_bit_is_found_where_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("paper").join("f32-local-level-taylor-0-4-0.chain");
    let original = golden_folder().join("paper").join("f32-local-level-taylor-0-4-0.chain");
    let text = std::fs::read_to_string(&original).unwrap();
    let line = text.lines().find(|line| line.starts_with("nav 40 ")).unwrap();
    let mut words: Vec<String> = line.split(' ').map(str::to_owned).collect();
    // The first word after stage and sample is the latitude.
    let bits = u32::from_str_radix(&words[2], 16).unwrap() + 1;
    words[2] = format!("{bits:08x}");
    std::fs::create_dir(file.parent().unwrap()).unwrap();
    std::fs::write(&file, text.replace(line, &words.join(" "))).unwrap();

    let place = "sample 40, stage nav, field position x.hi: 1 ulp";
    let verified = schuler(&["verify", folder.path().to_str().unwrap()]);
    assert_eq!(verified.status.code(), Some(1));
    assert!(printed(&verified).contains(place), "{}", printed(&verified));
    let (a, b) = (original.to_str().unwrap(), file.to_str().unwrap());
    let out = folder.path().join("out");
    let compared = schuler(&["compare", a, b, "--out", out.to_str().unwrap()]);
    assert_eq!(compared.status.code(), Some(1));
    let text = printed(&compared);
    assert!(text.contains(place) && text.contains(&format!("0x{bits:08x}")), "{text}");
    let json = std::fs::read_to_string(out.join("audit.json")).unwrap();
    assert!(json.contains("\"sample\": 40") && json.contains("\"ulps\": 1"), "{json}");
    assert!(std::fs::read_to_string(out.join("audit.html")).unwrap().contains("position x.hi"));

    let alike = schuler(&["compare", a, a]);
    assert_eq!(alike.status.code(), Some(0));
    assert!(printed(&alike).contains("the same bits"));
}

#[test]
fn another_seed_parts_at_the_first_sample_of_the_noise() {
    let cadence = Cadence { checkpoint: 4, rows: 8 };
    let mut scene = builtin::scene("paper").unwrap();
    scene.duration_s = 1.0;
    let chains = |seed| {
        let mut scene = scene.clone();
        scene.seed = seed;
        record(&scene, &ALL[..1], cadence, "").unwrap()
    };
    let (one, other) = (chains(1), chains(2));
    let parting = |stem: &str| {
        let of = |chains: &[(String, Chain)]| {
            chains.iter().find(|(name, _)| name == stem).unwrap().1.clone()
        };
        compare(&of(&one), &of(&other), "").unwrap().1
    };
    assert_eq!(parting("trajectory"), None);
    assert_eq!(parting("increments"), None);
    let noise = parting("noise").unwrap();
    assert_eq!((noise.sample, noise.alike), (1, 0));
    assert_eq!(noise.field.unwrap().field, "angle_b x");
    assert_eq!(parting("f64-local-level-textbook").unwrap().stage, "body");
}

#[test]
fn rows_left_out_change_no_digest() {
    let mut scene = builtin::scene("hard").unwrap();
    scene.duration_s = 1.0;
    let chains = |rows| record(&scene, ALL, Cadence { checkpoint: 16, rows }, "").unwrap();
    let mut left_out = 0;
    for ((name, all), (_, few)) in chains(u64::MAX).iter().zip(&chains(10)) {
        let (held, parting) = compare(all, few, "").unwrap();
        assert_eq!(parting, None, "{name}");
        let rows = |chain: &Chain| chain.stages.iter().map(|stage| stage.rows.len()).sum::<usize>();
        assert_eq!(held.rows, rows(few), "{name}");
        left_out += rows(all) - rows(few);
        assert_eq!(golden::digest(all), golden::digest(few));
    }
    assert!(left_out > 500, "{left_out}");
}

#[test]
fn one_ulp_does_what_mechanics_says() {
    let mut scene = builtin::scene("stationary").unwrap();
    scene.duration_s = 10.0;
    scene.navigator.precision = Precision::F32x2;
    let effects = sensitivity::sensitivity(&scene, &[1.0, 10.0]).unwrap();
    let find = |input: &str| effects.iter().find(|effect| effect.input == input).unwrap();
    // An ulp of latitude at 45° is 6e-8 rad of 6.4e6 m, and stays what it is.
    let latitude = find("initial latitude");
    for moved in &latitude.after {
        assert!((moved.position_m[0] / (latitude.ulp * 6.38e6) - 1.0).abs() < 0.1, "{moved:?}");
    }
    // One of altitude too, but for gravity's gradient: 1.0 + ½·3.1e-6 s⁻²·t².
    let altitude = find("initial altitude");
    assert!((altitude.after[1].position_m[2] / -altitude.ulp - 1.0).abs() < 1e-3);
    // Twenty a second of vertical specific force: ½ (20 ulp/s) t².
    let force = find("accel z of every sample");
    let expected = 0.5 * 20.0 * force.ulp * 10.0 * 10.0;
    let moved = force.after[1].norms()[0];
    assert!((moved / expected - 1.0).abs() < 0.1, "{moved} against {expected}");
}

#[test]
fn bad_input_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let empty = folder.path().to_str().unwrap();
    for (arguments, words) in [
        (vec!["verify", empty], "holds no chain"),
        (vec!["verify", "/nowhere"], "cannot be read"),
        (vec!["record", "paper", "--out", empty, "--configuration", "f16"], "there is no f16"),
        (vec!["sensitivity", "hard", "--after", "61"], "no sample at 61 s"),
        (vec!["record", "papper", "--out", empty], "did you mean"),
    ] {
        let output = schuler(&arguments);
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{error}");
        assert!(error.contains(words), "{error}");
    }
}
