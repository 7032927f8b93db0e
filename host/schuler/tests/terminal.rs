//! What the terminal shows: tables of 80 columns, and words for what cannot be.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn schuler(folder: &Path, line: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    command.current_dir(folder).args(line.split_whitespace()).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn tables_fit_80_columns() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let chains = "audit record paper --duration 5 --configuration f64-local-level-taylor-2-4-2";
    for line in [
        "run paper --duration 120",
        "run paper-perfect --duration 20",
        "run sea-state --duration 60 --vertical held",
        "hil paper --duration 5 --faults all=0.05 --out hil",
        "ensemble paper --runs 32 --duration 120 --budget",
        "allan paper --duration 600",
        "stress --case subnormal",
        "frontier --quick --scene stationary --rate 20",
        "audit sensitivity paper --duration 20",
        "align align-still --for 60",
        "run aided-drive --duration 60 --no-report --out aided",
        "ensemble aided-drive --runs 4 --duration 60 --out many",
        "scenes",
        &format!("{chains} --out chains"),
        "audit verify chains",
        "trajectory drive",
        "emulate paper --duration 20 --out imu.csv --truth truth.csv",
        "replay --imu imu.csv --initial initial.toml --reference truth.csv --out again/",
    ] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
        let words = line.split_whitespace();
        let done = command.current_dir(folder).args(words).env("COLUMNS", "80").output().unwrap();
        assert!(done.status.success(), "{line}: {}", text(&done.stderr));
        // Only a path without a blank may be longer.
        for told in text(&done.stdout).lines().filter(|told| told.trim().contains(' ')) {
            assert!(told.chars().count() <= 80, "{line}: {} columns: {told}", told.chars().count());
        }
        // Progress is for a terminal, which the error stream is not.
        let said = text(&done.stderr);
        assert!(
            !said.contains('\r') && !said.contains(" done, ") && !said.contains(" left"),
            "{said}"
        );
    }
}

#[test]
fn documents_are_printed_as_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let told = text(&schuler(folder.path(), "scenes paper").stdout);
    let scene = schuler_simulator::scene::builtin::text("paper").unwrap();
    assert_eq!(told, scene);
    let keys = text(&schuler(folder.path(), "scenes --keys").stdout);
    assert!(keys == schuler_simulator::scene::keys::reference());
}

#[test]
fn a_picture_for_documents_is_written_where_it_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let made = schuler(folder, "emulate drive --duration 20 --out imu.csv --truth truth.csv");
    assert!(made.status.success(), "{}", text(&made.stderr));
    let replay =
        "replay --imu imu.csv --initial initial.toml --reference truth.csv --svg --out again/";
    for (line, file) in [
        ("hil paper --duration 5 --svg --out run-hil", "run-hil/drift.svg"),
        (replay, "again/drift.svg"),
        ("run paper --duration 20 --svg --out run", "run/drift.svg"),
        ("ensemble paper --runs 8 --duration 60 --svg --out runs", "runs/ensemble.svg"),
        ("allan paper --duration 600 --svg --out allan", "allan/allan.svg"),
    ] {
        let done = schuler(folder, line);
        assert!(done.status.success(), "{line}: {}", text(&done.stderr));
        let picture = fs::read_to_string(folder.join(file)).unwrap();
        assert!(picture.starts_with("<svg xmlns=") && picture.ends_with("</svg>\n"), "{file}");
        assert!(picture.matches("<path").count() > 20 && !picture.contains("NaN"), "{file}");
        // Without the option an earlier one does not stay beside what is new.
        if file.ends_with("drift.svg") {
            let again = schuler(folder, &line.replace(" --svg", ""));
            assert!(again.status.success() && !folder.join(file).exists(), "{line}");
        }
    }
    let refused = schuler(folder, "allan paper --svg");
    assert_eq!(refused.status.code(), Some(2));
}

#[test]
fn perfect_sensors_have_no_theory_beside_them() {
    let folder = tempfile::tempdir().unwrap();
    let done = schuler(folder.path(), "run paper-perfect --duration 20 --no-report");
    assert!(done.status.success() && !text(&done.stdout).contains('±'), "{}", text(&done.stdout));
}

#[test]
fn half_a_degree_is_told_in_degrees() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "duration_s = 20\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n\
                 [initial_error]\nattitude_down_arcsec = 1900\n";
    fs::write(folder.path().join("off.toml"), scene).unwrap();
    let told = text(&schuler(folder.path(), "run off.toml --no-report").stdout);
    assert!(told.contains("|attitude| °"), "{told}");
    fs::write(folder.path().join("off.toml"), scene.replace("1900", "1700")).unwrap();
    let told = text(&schuler(folder.path(), "run off.toml --no-report --out less").stdout);
    assert!(told.contains("|attitude| arcsec"), "{told}");
}

#[test]
fn an_option_out_of_its_range_names_the_range() {
    let folder = tempfile::tempdir().unwrap();
    for (line, accepted) in [
        ("run paper --duration -1", "accepted: "),
        ("run paper --rate 0", "accepted: "),
        ("run paper --seed -1", "an integer from 0 to"),
        ("run paper --run -1", "accepted: "),
        ("run paper --every 0", "accepted: "),
        ("ensemble paper --runs 1", "from 4 to"),
        ("ensemble paper --runs 8 --threads 0", "from 1 to"),
        ("ensemble paper --runs 8 --threads -1", "from 1 to"),
        ("hil paper --retries -1", "from 0 to"),
        ("hil paper --faults drop=0.1 --fault-seed -1", "from 0 to"),
        ("hil paper --timeout 0", "from 0.001 to 3600"),
        ("audit record paper --checkpoint 0 --out o", "from 1 to"),
        ("audit record paper --checkpoint -1 --out o", "from 1 to"),
    ] {
        let done = schuler(folder.path(), line);
        let said = text(&done.stderr);
        assert_eq!(done.status.code(), Some(2), "{line}: {said}");
        assert!(said.contains(accepted), "{line}: {said}");
    }
}

#[test]
fn an_image_is_for_qemu_alone() {
    let folder = tempfile::tempdir().unwrap();
    for device in ["", " --device twin", " --device tcp:localhost:1"] {
        let done = schuler(folder.path(), &format!("hil paper --image navigator{device}"));
        let said = text(&done.stderr);
        assert_eq!(done.status.code(), Some(2), "{said}");
        assert!(said.contains("--image: the device t") && said.contains("--device qemu"), "{said}");
    }
}

#[test]
fn a_folder_that_is_a_file_is_called_one() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("taken"), "mine").unwrap();
    for line in [
        "run paper --duration 5 --out taken",
        "hil paper --duration 5 --out taken",
        "ensemble paper --runs 8 --duration 5 --out taken",
        "allan paper --duration 60 --out taken",
        "frontier --quick --out taken",
        "stress --case subnormal --out taken",
        "audit sensitivity paper --duration 5 --out taken",
    ] {
        let done = schuler(folder.path(), line);
        let said = text(&done.stderr);
        assert_eq!(done.status.code(), Some(2), "{line}: {said}");
        assert!(said.contains("taken") && said.contains("taken is no folder"), "{line}: {said}");
    }
    assert_eq!(fs::read_to_string(folder.path().join("taken")).unwrap(), "mine");
}

#[test]
fn what_another_command_left_is_not_replaced_in_silence() {
    let folder = tempfile::tempdir().unwrap();
    let run = |line: &str| text(&schuler(folder.path(), line).stderr);
    assert_eq!(run("run paper --duration 5 --no-report"), "");
    assert_eq!(run("run paper --duration 5 --no-report"), "");
    let said = run("run paper --duration 5 --no-report --seed 2");
    assert!(
        said.contains("out/paper") && said.contains("`schuler run paper --duration 5 --no-report`")
    );
    assert!(said.contains("--out keeps both"), "{said}");
    assert_eq!(run("run paper --duration 5 --no-report --seed 3 --out other"), "");
    let said = run("hil paper --duration 5 --no-report");
    assert!(said.contains("--seed 2`"), "{said}");
    let many = "ensemble paper --runs 8 --duration 5";
    assert_eq!((run(many), run(many)), (String::new(), String::new()));
    let said = run(&format!("{many} --seed 2"));
    assert!(
        said.contains("`schuler ensemble paper --runs 8 ") && !said.contains("--seed"),
        "{said}"
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_path_need_not_be_unicode() {
    use std::os::unix::ffi::OsStrExt;
    let folder = tempfile::tempdir().unwrap();
    let odd = std::ffi::OsStr::from_bytes(b"caf\xe9");
    let work = folder.path().join(odd);
    fs::create_dir(&work).unwrap();
    let run = |arguments: &[&std::ffi::OsStr]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
        let done = command.current_dir(folder.path()).args(arguments).output().unwrap();
        assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    };
    let words = |line: &'static str| line.split(' ').map(std::ffi::OsStr::new).collect::<Vec<_>>();
    let out = work.join("out");
    run(&[&words("run paper --duration 5 --out")[..], &[out.as_os_str()]].concat());
    assert!(out.join("report.html").is_file() && out.join("summary.json").is_file());
    let scene = work.join("scene.toml");
    fs::write(&scene, "duration_s = 5\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n").unwrap();
    run(&[&words("run")[..], &[scene.as_os_str()], &words("--no-report --out plain")].concat());
    let imu = work.join("imu.csv");
    run(&[&words("emulate paper --duration 5 --out")[..], &[imu.as_os_str()]].concat());
    let (nav, initial) = (work.join("nav.csv"), work.join("initial.toml"));
    let all = [
        &words("replay --imu")[..],
        &[imu.as_os_str()],
        &words("--initial"),
        &[initial.as_os_str()],
    ];
    run(&[&all.concat()[..], &words("--out"), &[nav.as_os_str()]].concat());
    assert!(nav.is_file());
}

#[test]
fn errors_and_warnings_fit_the_terminal() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let narrow = |line: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
        command.current_dir(folder).args(line.split_whitespace()).env("COLUMNS", "60");
        let told = text(&command.output().unwrap().stderr);
        assert!(told.lines().all(|told| told.chars().count() <= 60), "{line}: {told}");
        told
    };
    assert!(schuler(folder, "run paper --duration 5 --out out").status.success());
    let told = narrow("run paper --duration 5 --seed 2 --out out");
    assert!(told.starts_with("schuler: replaces in out the files of"), "{told}");
    for (line, words) in [
        ("run nowhere", "there is no such scene"),
        ("run paper --window 1", "--window"),
        ("align", "nothing to align"),
    ] {
        let wide = text(&schuler(folder, line).stderr);
        assert!(wide.contains(words), "{wide}");
        assert!(wide.lines().any(|told| told.chars().count() > 60), "{line}: {wide}");
        let told = narrow(line);
        let flat = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(flat(&told), flat(&wide));
    }
}
