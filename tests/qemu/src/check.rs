//! Every image on every machine: flown, compared with the program on this machine, measured.

use super::budget::{Column, MEASURES, Source, Table, written};
use super::hil;
use super::image::{self, Image};
use super::machine::{MACHINES, Machine};
use super::paths;
use super::qemu::{self, Flight};
use super::twin::TWINS;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::thread;

/// Where everything is.
#[derive(Clone, Debug)]
pub struct Places {
    /// Cargo's target directory of the firmware.
    pub images: PathBuf,
    /// The program `schuler`.
    pub schuler: PathBuf,
    /// The stored table.
    pub budget: PathBuf,
}

/// What was found on a machine.
struct Found {
    column: Column,
    /// What does not hold.
    faults: Vec<String>,
}

/// A machine's name with its core's, as the table has it.
fn title(machine: &Machine) -> String {
    format!("{} ({})", machine.core, machine.name)
}

/// Flies and measures everything; stores the table, or compares. Whether all is well.
pub fn run(places: &Places, store: bool) -> Result<bool, String> {
    let twins = twins(places)?;
    let queue = Mutex::new(MACHINES.iter());
    let found = Mutex::new(Vec::new());
    let work = || {
        loop {
            let Some(machine) = queue.lock().ok().and_then(|mut queue| queue.next()) else {
                return;
            };
            let result = examine(machine, places, &twins);
            if let Ok(mut found) = found.lock() {
                found.push((machine, result));
            }
        }
    };
    thread::scope(|scope| {
        scope.spawn(work);
        scope.spawn(work);
    });
    let found = found.into_inner().map_err(|_| "a flight's thread failed")?;
    let mut table = Table::default();
    let mut well = found.len() == MACHINES.len();
    for (machine, result) in found {
        let Found { column, faults } =
            result.map_err(|what| format!("{}: {what}", title(machine)))?;
        for fault in &faults {
            println!("{}: {fault}", title(machine));
        }
        well &= faults.is_empty();
        table.add(title(machine), column);
    }
    let text = table.text(&MACHINES.iter().map(title).collect::<Vec<_>>());
    println!("{text}");
    let path = places.budget.display();
    if store {
        std::fs::write(&places.budget, text).map_err(|error| format!("{path}: {error}"))?;
        println!("stored in {path}");
        return Ok(well);
    }
    let stored =
        std::fs::read_to_string(&places.budget).map_err(|error| format!("{path}: {error}"))?;
    let stored = Table::parse(&stored).map_err(|error| format!("{path}: {error}"))?;
    let (moved, skipped) = table.moved(&stored);
    skipped.iter().chain(&moved).for_each(|line| println!("{line}"));
    Ok(well && moved.is_empty())
}

/// Digests of the flights of each length that some machine makes, by the program here.
fn twins(places: &Places) -> Result<BTreeMap<(u32, &'static str), String>, String> {
    let mut digests = BTreeMap::new();
    for machine in MACHINES {
        for twin in TWINS {
            let key = (machine.flight_s, twin.name);
            if let Entry::Vacant(place) = digests.entry(key) {
                place.insert(twin.digest(&places.schuler, machine.flight_s)?);
            }
        }
    }
    Ok(digests)
}

fn examine(
    machine: &Machine,
    places: &Places,
    twins: &BTreeMap<(u32, &'static str), String>,
) -> Result<Found, String> {
    let read =
        |name: &str| Image::read(&places.images.join(machine.target).join("release").join(name));
    let mut faults = Vec::new();
    let mut selftest = read("selftest")?;
    selftest.set(&format!("FLIGHT_S={}", machine.flight_s))?;
    let flown = qemu::fly(machine, &selftest, &mut |_| ())?;
    if !flown.passed {
        faults.push(format!("the self-test failed: {:?}", flown.values));
    }
    for twin in TWINS {
        let here = twins.get(&(machine.flight_s, twin.name)).map(String::as_str);
        let there = flown.text(&format!("{}, digest", twin.name))?;
        if here != Some(there) {
            let here = here.unwrap_or_default();
            faults.push(format!("{}: digest {there}, but {here} on this machine", twin.name));
        }
    }
    if can_pass_with_a_broken_bound(machine, &selftest)? {
        faults.push("the self-test passes though its bound is 0 m".to_owned());
    }
    let measured = qemu::fly(machine, &read("budget")?, &mut |_| ())?;
    if !measured.passed {
        faults.push(format!("the image `budget` failed: {:?}", measured.values));
    }
    // An aided flight does not fit the RAM of a micro:bit.
    let aiding = match machine.board {
        "microbit" => None,
        _ => Some(qemu::fly(machine, &read("aiding")?, &mut |_| ())?),
    };
    if let Some(aiding) = aiding.as_ref().filter(|aiding| !aiding.passed) {
        faults.push(format!("the image `aiding` failed: {:?}", aiding.values));
    }
    let (single, planned) = (read("single")?, read("single-planned")?);
    let navigator = read("navigator-f32")?;
    for image in [&single, &planned, &navigator] {
        faults.extend(forbidden(image, machine)?);
    }
    for image in [&selftest, &navigator] {
        let of_core = image.statics()?.into_iter().filter(|name| image::is_of_core(name));
        faults.extend(of_core.map(|name| format!("the core has a static: {name}")));
    }
    if let Some(said) = hil::fly(machine, &navigator, &places.schuler)? {
        faults.push(format!("schuler hil: {said}"));
    }
    if *machine == MACHINES[0] {
        let every = read("navigator")?;
        faults.extend(panics(&every)?);
        faults.extend(hil::emulated(&every, &hil::EVERY, &places.schuler)?);
        let aided = read("navigator-aided")?;
        faults.extend(forbidden(&aided, machine)?);
        faults.extend(hil::emulated(&aided, &hil::AIDED, &places.schuler)?);
        let circuit = read("circuit")?;
        // Its reports can panic, as those of the self-test can; nothing else may.
        let reporting = selftest.symbols()?;
        let mut own = circuit.symbols()?;
        own.retain(|symbol| image::can_panic(symbol) && !reporting.contains(symbol));
        faults.extend(own.iter().map(|symbol| format!("circuit can panic: {symbol}")));
        faults.extend(paths::fly(machine, &circuit)?);
    }
    let column = column(&[&single, &planned], [&measured, &flown], aiding.as_ref())?;
    // The budgets are those of the reference board's target.
    if machine.target == MACHINES[0].target {
        for (measure, value) in MEASURES.iter().zip(&column.1) {
            if let Some(budget) = measure.budget
                && (*value > budget || value.is_nan())
            {
                faults.push(format!("{}: {value}, budget {budget}", measure.what));
            }
        }
    }
    Ok(Found { column: column.0, faults })
}

/// The self-test with a bound that nothing keeps: it must fail.
fn can_pass_with_a_broken_bound(machine: &Machine, selftest: &Image) -> Result<bool, String> {
    let mut broken = selftest.clone();
    broken.set("FLIGHT_S=2")?;
    broken.set("SINGLE_BOUND_M=0.0")?;
    Ok(qemu::fly(machine, &broken, &mut |_| ())?.passed)
}

/// Symbols by which an image could panic.
fn panics(image: &Image) -> Result<Vec<String>, String> {
    let name = image.name();
    let symbols = image.symbols()?.into_iter().filter(|symbol| image::can_panic(symbol));
    Ok(symbols.map(|symbol| format!("{name} can panic: {symbol}")).collect())
}

/// Symbols that may not be in an image that navigates in f32.
fn forbidden(image: &Image, machine: &Machine) -> Result<Vec<String>, String> {
    let name = image.name();
    let mut found = panics(image)?;
    for symbol in image.symbols()? {
        if machine.target == MACHINES[0].target && image::is_soft_double(&symbol) {
            found.push(format!("{name} computes in f64: {symbol}"));
        }
    }
    Ok(found)
}

/// A machine's numbers, as written and as measured.
fn column(
    [single, planned]: &[&Image; 2],
    [measured, flown]: [&Flight; 2],
    aiding: Option<&Flight>,
) -> Result<(Column, Vec<f64>), String> {
    let mut values = Vec::new();
    for measure in MEASURES {
        values.push(match measure.source {
            Source::Budget(key) => measured.number(key)?,
            Source::Selftest(key) => flown.number(key)?,
            Source::Aiding(key) => aiding.map_or(Ok(f64::NAN), |aiding| aiding.number(key))?,
            Source::Step => single.size_of(image::is_of_step)? as f64,
            Source::PlannedStep => planned.size_of(image::is_of_step)? as f64,
            Source::Image => single.size(&[".text", ".rodata"])? as f64,
            Source::Statics => single.size(&[".data", ".bss"])? as f64,
        });
    }
    let written = values.iter().map(|&value| written(value)).collect();
    Ok((Column { compiler: single.compiler()?, values: written }, values))
}

/// A path given on the command line, as it is.
pub fn places(images: &str, schuler: &str, budget: &str) -> Places {
    let own = |path: &str| Path::new(path).to_owned();
    Places { images: own(images), schuler: own(schuler), budget: own(budget) }
}
