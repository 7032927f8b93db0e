//! `schuler audit`: golden chains, a planted bit, and what one unit in the last place does.

use schuler_host::audit::chain::Chain;
use schuler_host::audit::compare::compare;
use schuler_host::audit::record::{Cadence, record};
use schuler_host::audit::{functions, golden, sensitivity};
use schuler_simulator::navigator::stepping::all;
use schuler_simulator::scene::{Precision, builtin};
use std::path::Path;
use std::process::{Command, Output};

pub fn golden_folder() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/golden"))
}

pub fn schuler(arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_schuler");
    Command::new(program).arg("audit").args(arguments).output().unwrap()
}

pub fn printed(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

#[test]
fn this_build_has_the_golden_bits() {
    let verdicts = golden::verify(golden_folder(), &mut |_| Ok(())).unwrap();
    // Two scenes: three stages that all share, and every navigator.
    assert_eq!(verdicts.len(), 2 * (3 + all().len()));
    for verdict in verdicts {
        assert_eq!(verdict.parting, None, "{}", verdict.chain);
    }
}

#[test]
fn a_libm_with_other_bits_is_named() {
    let stored = std::fs::read_to_string(golden_folder().join(functions::FILE)).unwrap();
    let folder = alone("turns", "noise", str::to_owned);
    std::fs::copy(golden_folder().join("turns.toml"), folder.path().join("turns.toml")).unwrap();
    let verify = |changed: &str| {
        std::fs::write(folder.path().join(functions::FILE), changed).unwrap();
        schuler(&["verify", folder.path().to_str().unwrap()])
    };
    let output = verify(&stored);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(printed(&output).contains("12 functions of libm"), "{output:?}");
    let line = stored.lines().find(|line| line.starts_with("f32 atan2 ")).unwrap();
    let output = verify(&stored.replace(line, "f32 atan2 0123456789abcdef"));
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let text = printed(&output);
    let differing: Vec<_> = text.lines().filter(|line| line.contains("DIFFERS")).collect();
    assert!(differing.len() == 1 && differing[0].starts_with("f32 atan2 "), "{text}");
    assert!(text.contains("has other bits than the golden chains'"), "{text}");
    assert!(text.contains("1 chains, 0 of them part"), "{text}");
    let output = verify(&stored.replace(line, ""));
    assert_eq!(output.status.code(), Some(2), "{output:?}");
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

    let place = "sample 40, stage nav, field position latitude.hi: 1 ulp";
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
    assert!(
        std::fs::read_to_string(out.join("audit.html")).unwrap().contains("position latitude.hi")
    );

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
        record(&scene, &all()[..1], cadence, "").unwrap()
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
    let chains = |rows| record(&scene, &all(), Cadence { checkpoint: 16, rows }, "").unwrap();
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
fn a_sample_is_looked_at_once_at_its_own_time() {
    let mut scene = builtin::scene("stationary").unwrap();
    scene.duration_s = 2.0;
    let at = |times_s: &[f64]| sensitivity::sensitivity(&scene, times_s).unwrap();
    let (one, other) = (at(&[2.0, 1.01, 1.0, 0.99]), at(&[1.0, 2.0]));
    for (one, other) in one.iter().zip(&other) {
        let times: Vec<_> = one.after.iter().map(|moved| moved.time_s).collect();
        assert_eq!(times, [1.0, 2.0], "{}", one.input);
        for (one, other) in one.after.iter().zip(&other.after) {
            assert_eq!(one.norms(), other.norms());
        }
    }
}

/// A golden chain of a scene, by itself in a folder.
pub fn alone(scene: &str, stem: &str, text: impl Fn(&str) -> String) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let file = format!("{stem}.chain");
    let golden = std::fs::read_to_string(golden_folder().join(scene).join(&file)).unwrap();
    std::fs::write(folder.path().join(file), text(&golden)).unwrap();
    folder
}

#[test]
fn a_single_scene_is_verified_by_itself() {
    let folder = alone("paper", "f64-local-level-textbook", str::to_owned);
    let output = schuler(&["verify", folder.path().to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let text = printed(&output);
    let chain = Chain::read(folder.path().join("f64-local-level-textbook.chain").to_str().unwrap());
    let chain = chain.unwrap();
    let rows: usize = chain.stages.iter().map(|stage| stage.rows.len()).sum();
    let digests: usize = chain.stages.iter().map(|stage| stage.checkpoints.len() + 1).sum();
    assert!(text.contains(&format!("{rows} rows and {digests} digests")), "{text}");
    // A scene that is not built in lies beside its folder.
    let verdicts = golden::verify(&golden_folder().join("turns"), &mut |_| Ok(())).unwrap();
    assert!(verdicts.iter().all(|verdict| verdict.parting.is_none()));
}

#[test]
fn a_golden_chain_has_to_be_whole() {
    let file = golden_folder().join("paper").join("noise.chain");
    let text = std::fs::read_to_string(file).unwrap();
    let lines = |keep: &dyn Fn(usize, &str) -> bool| {
        let kept = text.lines().enumerate().filter(|&(i, line)| keep(i, line));
        kept.map(|(_, line)| format!("{line}\n")).collect::<String>()
    };
    let early = text.replace("noise = 1200", "noise = 1199");
    let renamed = text.replacen("angle_b velocity_b", "angle_b speed_b", 1);
    for (changed, words) in [
        (lines(&|i, _| i < 11), "its stage noise has no end; accepted: noise = 1200 DIGEST"),
        (lines(&|_, line| !line.starts_with("noise = ")), "its stage noise has no end"),
        (
            lines(&|_, line| !line.contains("noise ")),
            "lacks the stage noise; accepted: stage: noise",
        ),
        (early, "its stage noise ends at sample 1199; accepted: noise = 1200 DIGEST"),
        (renamed, "its stage noise has other fields than the flight's; accepted: stage: noise f64"),
    ] {
        let folder = alone("paper", "noise", |_| changed.clone());
        let output = schuler(&["verify", folder.path().to_str().unwrap()]);
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{words}: {error}");
        assert!(error.contains("noise.chain") && error.contains(words), "{error}");
    }
}

#[test]
fn a_built_in_scene_is_recorded_whatever_lies_about() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("paper"), "of another kind").unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_schuler"))
        .args(["audit", "record", "paper", "--duration", "1", "--out", "out"])
        .args(["--configuration", "f64-local-level-textbook"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(folder.path().join("out/paper/noise.chain").exists());
    assert!(!folder.path().join("out/paper.toml").exists());
}

#[test]
fn a_port_is_compared_in_what_it_has() {
    let golden = golden_folder().join("paper").join("f32-local-level-taylor-0-4-0.chain");
    let golden = golden.to_str().unwrap();
    let chain = Chain::read(golden).unwrap();
    let nav = &chain.stages[1];
    let of = |name: &str| nav.fields.iter().position(|field| field == name).unwrap();
    let (velocity, attitude) = (of("velocity"), of("attitude"));
    let mut text = "schuler chain 1\nstage: nav f32".to_owned();
    text += &" velocity".repeat(6);
    text += &" attitude".repeat(8);
    text += "\n\n";
    for row in nav.rows.iter().take_while(|row| row.sample <= 64) {
        text += &format!("nav {}", row.sample);
        for word in row.words[velocity..][..6].iter().chain(&row.words[attitude..][..8]) {
            text += &format!(" {word:08x}");
        }
        text += "\n";
    }
    text += "nav = 64 0123456789abcdef\n";
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.chain");
    std::fs::write(&file, &text).unwrap();
    let (file, out) = (file.to_str().unwrap(), folder.path().to_str().unwrap());
    let output = schuler(&["compare", golden, file, "--out", out]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let found = crate::on_one_line(&printed(&output));
    for words in [
        "the same bits in 16 rows and 0 digests",
        "stage nav ends at 64 of 1200",
        "stage nav is compared in velocity, attitude, by rows alone",
        "only one chain has position, sine, cosine, curvature",
    ] {
        assert!(found.contains(words), "{found}");
    }
    assert!(std::fs::read_to_string(format!("{out}/audit.html")).unwrap().contains("64 of 1200"));
    let last = nav.rows[15].words[velocity + 3];
    let planted = format!(" {last:08x} ");
    let line = text.lines().find(|line| line.starts_with("nav 64 ")).unwrap();
    let changed = line.replacen(&planted, &format!(" {:08x} ", last + 1), 1);
    std::fs::write(file, text.replace(line, &changed)).unwrap();
    let output = schuler(&["compare", golden, file]);
    assert_eq!(output.status.code(), Some(1));
    let place = "sample 64, stage nav, field velocity east.lo: 1 ulp";
    assert!(printed(&output).contains(place), "{}", printed(&output));
}
