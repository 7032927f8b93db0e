//! Flies the firmware's images in QEMU; `tests/firmware.sh` calls it.

use schuler_qemu::image::Image;
use schuler_qemu::{check, machine, qemu};
use std::path::Path;
use std::process::ExitCode;

const USAGE: &str = "usage:
  schuler-qemu builds                                 every target with its board
  schuler-qemu run MACHINE IMAGE [--set NAME=VALUE]…  flies an image and prints what it reports
  schuler-qemu check [--store] IMAGES SCHULER BUDGET  every image on every machine, against the
                                                      program and the stored table";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match arguments[..] {
        ["builds"] => {
            for (target, board) in machine::builds() {
                println!("{target} {board}");
            }
            Ok(true)
        }
        ["check", images, schuler, budget] => {
            check::run(&check::places(images, schuler, budget), false)
        }
        ["check", "--store", images, schuler, budget] => {
            check::run(&check::places(images, schuler, budget), true)
        }
        ["run", machine, image, ref options @ ..] => run(machine, image, options),
        _ => Err(USAGE.to_owned()),
    };
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(what) => {
            eprintln!("schuler-qemu: {what}");
            ExitCode::from(2)
        }
    }
}

fn run(machine: &str, image: &str, options: &[&str]) -> Result<bool, String> {
    let machine = machine::named(machine)?;
    let mut image = Image::read(Path::new(image))?;
    for pair in options.chunks(2) {
        match pair {
            ["--set", assignment] => image.set(assignment)?,
            _ => return Err(USAGE.to_owned()),
        }
    }
    Ok(qemu::fly(&machine, &image, &mut |line| println!("{line}"))?.passed)
}
