//! `schuler emulate`: the sensor samples of a scene as a file, with the start and the truth beside it.

use crate::cli::EmulateArgs;
use schuler_simulator::aided::columns::MeasurementWriter;
use schuler_simulator::aided::measurements;
use schuler_simulator::formats::mcap::{McapWriter, Motion};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::{self, OutputFile, much, say, say_error};
use schuler_simulator::progress::Progress;
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow, NavigationWriter};
use schuler_simulator::recording::writer::ImuWriter;
use schuler_simulator::scene::Scene;
use schuler_simulator::simulate::{FlightError, start};
use schuler_simulator::source::Source;
use std::path::Path;

/// Writes the stream; what is lost on the link is missing in it, but not in the truth.
pub fn emulate(args: &EmulateArgs) -> Result<(), FlightError> {
    let scene = args.scene()?;
    let source = Source::new(&scene, false)?;
    let mut stream = source.start(args.number);
    let progress = Progress::new(scene.samples());
    let create = if args.rates { ImuWriter::rates } else { ImuWriter::increments };
    let mut writer = create(&args.out)?;
    let mut files = Vec::new();
    if let Some(path) = args.initial() {
        files.push(initial(&path, &scene, &source, args.number)?);
    }
    let mut truth = args.truth.as_ref().map(NavigationWriter::create).transpose()?;
    let gnss =
        args.gnss.as_ref().map(|path| gnss(path, &scene, &source, args.number)).transpose()?;
    announce(args, &scene);
    let mut messages = args.mcap.as_ref().map(McapWriter::create).transpose()?;
    let mut write_truth = |messages: &mut Option<McapWriter>, sample: u64| {
        if truth.is_none() && messages.is_none() {
            return Ok(());
        }
        let (time_s, state) = (source.time_s(sample), source.truth(sample));
        if let Some(messages) = messages {
            messages.state(Motion::Truth, time_s, &state)?;
        }
        truth.as_mut().map_or(Ok(()), |truth| truth.row(&NavigationRow::new(time_s, &state)))
    };
    write_truth(&mut messages, 0)?;
    let mut written = 0;
    for sample in 1..=scene.samples() {
        let time_s = source.time_s(sample);
        if args.rates {
            if let Some(rates) = stream.advance_rates() {
                writer.rate(time_s, &rates)?;
                if let Some(messages) = &mut messages {
                    messages.rates(time_s, &rates, None)?;
                }
                written += 1;
            }
        } else if let Some(increment) = stream.advance() {
            writer.increment(time_s, &increment)?;
            if let Some(messages) = &mut messages {
                messages.increment(time_s, 1.0 / scene.rate_hz, &increment)?;
            }
            written += 1;
        }
        write_truth(&mut messages, sample)?;
        progress.reach(sample);
    }
    progress.finish();
    files.extend(gnss);
    files.extend(truth.map(NavigationWriter::into_file));
    files.extend(messages.map(McapWriter::into_file).transpose()?);
    let beside = files.iter().map(|file| format!(", {}", file.path().display()));
    let beside: String = beside.collect();
    files.push(writer.into_file());
    output::place(files, &[])?;
    let lost = scene.samples() - written;
    let lost = if lost > 0 { format!(", {lost} lost on the link") } else { String::new() };
    say(&format!("{written} samples written to {}{beside}{lost}\n", args.out.display()))?;
    Ok(())
}

/// What the sensors of a run that aid its navigator deliver, in the order of arrival.
fn gnss(path: &Path, scene: &Scene, source: &Source, run: u64) -> Result<OutputFile, FlightError> {
    if !scene.aiding.is_there() {
        let what = format!("{} has no sensor that aids navigation", scene.name);
        let accepted =
            "a scene with [gnss], [barometer], [odometer], [zero_velocity] or [non_holonomic]";
        return Err(InputError::option("--gnss", Complaint::new(what, accepted)).into());
    }
    let mut writer = MeasurementWriter::create(path)?;
    for measured in measurements::of_run(scene, source, run) {
        let [time_s, arrives_s] = measurements::times_s(&measured, scene.rate_hz);
        writer.row(time_s, arrives_s, &measured.1)?;
    }
    Ok(writer.into_file())
}

/// The state that a run's navigation starts from, off by what the scene says.
fn initial(
    path: &Path,
    scene: &Scene,
    source: &Source,
    run: u64,
) -> Result<OutputFile, FlightError> {
    let start = start::of_run(&source.initial(0), scene, run);
    let mut file = OutputFile::create(path)?;
    let is_off = scene.initial_error != Default::default();
    let off = if is_off { ", off by its initial_error" } else { "" };
    let about = format!("The start of {}{off}: for `schuler replay --initial`", scene.name);
    file.put(NavigationRow::start(source.time_s(0), &start).toml(&about))?;
    Ok(file)
}

/// Says how much room large files take.
fn announce(args: &EmulateArgs, scene: &Scene) {
    let truth = args.truth.as_deref().map(|path| (path, COLUMNS.len()));
    for (path, columns) in
        [Some((args.out.as_path(), ImuWriter::COLUMNS)), truth].into_iter().flatten()
    {
        if let Some(much) = much(path, scene.samples(), columns) {
            say_error(&format!("{much}; --rate and --duration make it less"));
        }
    }
}
