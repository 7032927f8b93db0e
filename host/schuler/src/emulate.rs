//! `schuler emulate`: the sensor samples of a scene as a file.

use crate::cli::EmulateArgs;
use schuler_simulator::output::{much, say};
use schuler_simulator::progress::Progress;
use schuler_simulator::recording::writer::ImuWriter;
use schuler_simulator::simulate::FlightError;
use schuler_simulator::source::Source;

/// Writes the stream; what is lost on the link is missing in the file.
pub fn emulate(args: &EmulateArgs) -> Result<(), FlightError> {
    let scene = args.scene()?;
    let source = Source::new(&scene, false)?;
    let mut stream = source.start(0);
    let progress = Progress::new(scene.samples());
    let create = if args.rates { ImuWriter::rates } else { ImuWriter::increments };
    let mut writer = create(&args.out)?;
    if let Some(much) = much(&args.out, scene.samples(), ImuWriter::COLUMNS) {
        eprintln!("{much}; --rate and --duration make it less");
    }
    let mut written = 0;
    for sample in 1..=scene.samples() {
        let time_s = source.time_s(sample);
        if args.rates {
            if let Some(rates) = stream.advance_rates() {
                writer.rate(time_s, &rates)?;
                written += 1;
            }
        } else if let Some(increment) = stream.advance() {
            writer.increment(time_s, &increment)?;
            written += 1;
        }
        progress.reach(sample);
    }
    progress.finish();
    writer.finish()?;
    let lost = scene.samples() - written;
    let lost = if lost > 0 { format!(", {lost} lost on the link") } else { String::new() };
    say(&format!("{written} samples written to {}{lost}\n", args.out.display()))?;
    Ok(())
}
