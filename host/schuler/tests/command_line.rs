//! The command line: every option, its limits, and what it does to a scene.

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser};
use schuler_host::cli::{Cli, Command, EmulateArgs, Height, Lag, ReplayArgs, RunArgs, ScenesArgs};
use schuler_simulator::scene::{Algorithm, Axes, Gap, Precision, Vertical, WindowShape};
use std::path::Path;

fn parse(line: &str) -> Result<Command, clap::Error> {
    Cli::try_parse_from(["schuler"].into_iter().chain(line.split_whitespace())).map(Cli::command)
}

fn run(line: &str) -> RunArgs {
    match parse(line).unwrap_or_else(|e| panic!("{line}: {e}")) {
        Command::Run(arguments) => arguments,
        other => panic!("{line}: {other:?}"),
    }
}

fn replay(line: &str) -> ReplayArgs {
    match parse(line).unwrap_or_else(|e| panic!("{line}: {e}")) {
        Command::Replay(arguments) => *arguments,
        other => panic!("{line}: {other:?}"),
    }
}

fn emulate(line: &str) -> EmulateArgs {
    match parse(line).unwrap_or_else(|e| panic!("{line}: {e}")) {
        Command::Emulate(arguments) => arguments,
        other => panic!("{line}: {other:?}"),
    }
}

#[test]
fn definitions_are_consistent_and_help_has_examples() {
    let mut command = <Cli as CommandFactory>::command();
    command.clone().debug_assert();
    let help = command.render_help().to_string();
    assert!(
        help.starts_with("Flies a strapdown") && help.contains("Examples:\n  schuler "),
        "{help}"
    );
    for name in [
        "run",
        "emulate",
        "replay",
        "frontier",
        "stress",
        "ensemble",
        "hil",
        "scenes",
        "trajectory",
    ] {
        let help = command.find_subcommand_mut(name).expect(name).render_help().to_string();
        assert!(help.contains(&format!("\n  schuler {name}")), "{help}");
        let about = [
            "Fly ",
            "Write the",
            "Navigate a",
            "Run the table",
            "Measure run time",
            "List the built-in",
            "Describe a",
        ];
        assert!(about.iter().any(|about| help.starts_with(about)), "{help}");
    }
}

#[test]
fn running_is_the_default() {
    assert_eq!(run(""), RunArgs::default());
    assert_eq!(run("").scene().expect("built in").name, "paper");
    assert_eq!(run("hard --seed 3"), run("run hard --seed 3"));
    assert_eq!(parse("scenes").expect("valid"), Command::Scenes(ScenesArgs::default()));
}

#[test]
fn options_override_the_scene() {
    let arguments = run("run hard --out o --seed 5 --duration 30 --rate 50 --frame earth-fixed \
        --precision f32 --algorithm taylor --window 2,4,2 --force-all --no-report");
    assert_eq!(arguments.out.as_deref(), Some(Path::new("o")));
    assert!(arguments.force_all && arguments.no_report);
    let scene = arguments.scene().unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((scene.seed, scene.duration_s, scene.rate_hz), (5, 30.0, 50.0));
    let navigator = scene.navigator;
    assert_eq!(navigator.frame, Axes::EarthFixed);
    assert_eq!(navigator.precision, Precision::F32);
    assert_eq!(navigator.algorithm, Algorithm::Taylor);
    assert_eq!(navigator.window, Some(WindowShape { history: 2, block: 4, lookahead: 2 }));
    let error = run("run hard --algorithm textbook --window 2,4,2").scene().expect_err("no window");
    assert!(error.to_string().starts_with("--window: textbook has no window"), "{error}");
    assert_eq!(run("run --window auto").scene().expect("valid").navigator.window, None);
    // What is not given stays.
    assert_eq!(run("polar").scene().expect("valid").navigator.frame, Axes::EarthFixed);
    let frame = run("polar --frame local-level").scene().expect("valid").navigator.frame;
    assert_eq!(frame, Axes::LocalLevel);
}

#[test]
fn emulate_and_replay_take_what_they_need() {
    let arguments = emulate("emulate paper --out imu.csv --rates --seed 9");
    assert!(arguments.rates && !arguments.perfect);
    let scene = arguments.scene().expect("valid");
    assert_eq!(scene.seed, 9);
    assert!(scene.gyro.constant.is_some());
    let scene = emulate("emulate paper --out imu.csv --perfect").scene().expect("valid");
    assert_eq!((scene.gyro, scene.accelerometer), Default::default());

    let arguments = replay(
        "replay --imu i.csv --out n.csv --start 540 --align 120 --until 960 \
        --initial i.toml --frame earth-fixed --window 0,4,0",
    );
    assert_eq!(
        (arguments.start, arguments.align, arguments.until),
        (Some(540.0), Some(120.0), Some(960.0))
    );
    assert_eq!(arguments.initial.as_deref(), Some(Path::new("i.toml")));
    assert_eq!(arguments.navigator.frame, Some(Axes::EarthFixed));
    arguments.check().expect("the output is no input");
    assert_eq!(replay("replay --imu i --out n --start -5").start, Some(-5.0));
}

#[test]
fn the_vertical_and_gaps_are_options() {
    let navigator = |line: &str| run(line).scene().unwrap_or_else(|e| panic!("{e}")).navigator;
    let held = navigator("run paper --vertical held --gap bridge");
    assert_eq!((held.vertical, held.gap), (Vertical::Held, Gap::Bridge));
    let own = navigator("run sea-state");
    assert_eq!((own.vertical, own.gap), (Vertical::Held, Gap::Error));
    assert_eq!(navigator("run sea-state --vertical free").vertical, Vertical::Free);
    let Ok(Command::Ensemble(many)) = parse("ensemble --vertical held") else {
        panic!("not ensemble")
    };
    assert_eq!(many.scene().unwrap_or_else(|e| panic!("{e}")).navigator.vertical, Vertical::Held);
    let Ok(Command::Hil(hil)) = parse("hil --vertical held --gap bridge --rows") else {
        panic!("not hil")
    };
    assert!(hil.wanted().rows && hil.handling == run("--vertical held --gap bridge").handling);

    let plain = replay("replay --imu i --out n");
    assert_eq!((plain.vertical(), plain.height.clone()), (Vertical::Free, None));
    assert_eq!(plain.lag, Lag::Seconds(0.0));
    let height = |text: &str| {
        let replay = replay(&format!("replay --imu i --out n --height {text}"));
        assert_eq!(replay.vertical(), Vertical::Held);
        replay.height.expect("it is given")
    };
    assert_eq!(height("-12.5"), Height::Metres(-12.5));
    assert_eq!(height("truth.csv"), Height::File("truth.csv".into()));
    let reference = "replay --imu i --out n --reference r";
    assert_eq!(replay(&format!("{reference} --lag auto")).lag, Lag::Auto);
    assert_eq!(replay(&format!("{reference} --lag -0.5")).lag, Lag::Seconds(-0.5));
}

#[test]
fn stress_takes_a_part_of_a_name() {
    let Ok(Command::Stress(arguments)) = parse("stress --full --case coning --out o") else {
        panic!("not stress")
    };
    assert!(arguments.full);
    assert_eq!(arguments.case.as_deref(), Some("coning"));
    assert_eq!(arguments.out.as_deref(), Some(Path::new("o")));
    assert_eq!(parse("stress").expect("valid"), Command::Stress(Default::default()));
}

#[test]
fn usage_errors_name_the_option_and_exit_with_2() {
    for (line, words) in [
        ("--rate 0", ["--rate", "from 1 to 1e6"]),
        ("run --rate nan", ["--rate", "NaN is not a finite number"]),
        ("run --duration -1", ["--duration", "above 0"]),
        ("run --duration long", ["--duration", "is not a number"]),
        ("run --seed -1", ["--seed", "an integer from 0"]),
        ("run --frame sideways", ["--frame", "local-level, earth-fixed"]),
        ("run --precision f16", ["--precision", "f64, f32"]),
        ("run --algorithm magic", ["--algorithm", "taylor, textbook"]),
        ("run --window 1,2", ["--window", "2,4,2"]),
        ("run --window 2,0,2", ["--window", "there is no window 2,0,2"]),
        ("run --window 2,4,-2", ["--window", "is not a window"]),
        ("run --window 40,20,20", ["--window", "2,4,2"]),
        ("emulate hard", ["--out", "required"]),
        ("replay --out n.csv", ["--imu", "required"]),
        ("replay --imu i --out n --align 0", ["--align", "above 0"]),
        ("replay --imu i --out n --align 9 --heading 361", ["--heading", "from -360 to 360"]),
        ("replay --imu i --out n --heading 3", ["--align", "required"]),
        ("run --vertical high", ["--vertical", "free, held"]),
        ("run --gap jump", ["--gap", "error, bridge"]),
        ("ensemble --gap bridge", ["--gap", "unexpected"]),
        ("replay --imu i --out n --lag 1", ["--reference", "required"]),
        ("replay --imu i --out n --reference r --lag soon", ["--lag", "seconds, or auto"]),
        ("replay --imu i --out n --units furlong", ["--units", "m/s2 g mg"]),
        ("replay --imu i --out n --units g,mg", ["--units", "contradicts a word before"]),
        ("run --wobble", ["--wobble", "unexpected"]),
    ] {
        let error = parse(line).expect_err(line);
        assert_eq!(error.exit_code(), 2, "{line}");
        let message = error.to_string();
        for word in words {
            assert!(message.contains(word), "{line}: {message}\nwithout {word}");
        }
    }
    assert_eq!(parse("--help").expect_err("help").kind(), ErrorKind::DisplayHelp);
    assert_eq!(parse("--help").expect_err("help").exit_code(), 0);
}

#[test]
fn what_only_the_whole_scene_shows() {
    let error = |line| run(line).scene().expect_err(line).to_string();
    let message = error("run paper --duration 0.01");
    assert!(message.starts_with("--duration: 0.01 s at 20 Hz are 0 samples"), "{message}");
    let message = error("run sea-state --duration 1e9 --rate 1e3");
    assert!(message.starts_with("--duration: ") && message.contains("4294967295"), "{message}");
    let message = error("run no-such-scene");
    assert!(message.contains("no-such-scene") && message.contains("sea-state"), "{message}");
    for (slip, command) in [("ensembel", "`ensemble`"), ("replya", "`replay`")] {
        let message = error(slip);
        assert!(message.contains("did you mean") && message.contains(command), "{message}");
    }
}

#[test]
fn the_option_to_blame_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let scene = |text: &str| {
        let path = folder.path().join("scene.toml");
        let needed = "duration_s = 10\nrate_hz = 20\n";
        std::fs::write(&path, format!("{needed}{text}")).unwrap();
        move |options: &str| run(&format!("run {} {options}", path.display())).scene()
    };
    let blames = |outcome: Result<_, schuler_simulator::input::InputError>, start: &str| {
        let message = outcome.map(|scene: schuler_simulator::scene::Scene| scene.name);
        let message = message.expect_err(start).to_string();
        assert!(message.starts_with(start), "{message}\nnot    {start}");
    };
    let late = scene("[link]\njitter_s = 0.004\n");
    blames(late("--rate 200 --duration 20"), "--rate: with this, link.jitter_s ");
    let climbing = scene("[trajectory]\naltitude_m = { rate = 1000 }\n");
    let words = "--duration: with this, trajectory.altitude_m ";
    blames(climbing("--rate 40 --duration 2000"), words);
    let shaken = "[trajectory.roll_deg]\nharmonics = [{ amplitude = 1e-6, period_s = 4e-4 }]\n";
    blames(
        scene(shaken)("--rate 1 --duration 20"),
        "--rate: with this, trajectory.roll_deg is too",
    );

    let smoothed = scene(
        "[trajectory]\nlatitude_deg = 45\n[gyro]\nturn_on_bias_deg_h = 1\n\
         [accelerometer]\nturn_on_bias_ug = 1\n[gnss]\nrate_hz = 1\nposition_m = 1\n[filter]\nsmoother = true\n",
    );
    // Ten steps a second, and one for each fix.
    let words = "--duration: with this, filter.smoother takes ";
    let long = smoothed("--duration 1e6");
    let message = long.as_ref().map(|scene| scene.name.clone()).expect_err(words).to_string();
    assert!(message.contains(" GiB of memory for 11000000 steps"), "{message}");
    blames(long, words);

    let single = scene("[navigator]\nprecision = \"f32x2\"\n");
    single("--frame earth-fixed").expect("f32x2 has both frames");
    blames(single("--algorithm textbook"), "--algorithm: f32x2 is not to be had here");
    blames(single("--window 0,8,0"), "--window: f32x2 has no window 0,8,0; accepted: auto; 0,4,0");
    blames(
        run("paper --precision f32x2 --algorithm textbook").scene(),
        "--precision: f32x2 is not",
    );
    let window = "[navigator]\nwindow = { history = 0, block = 8, lookahead = 0 }\n";
    blames(scene(window)("--precision f32x2"), "--precision: f32x2 has no window 0,8,0");
    // The file's window is taylor's.
    let textbook = scene(window)("--algorithm textbook").expect("valid").navigator;
    assert_eq!((textbook.algorithm, textbook.window), (Algorithm::Textbook, None));
}
