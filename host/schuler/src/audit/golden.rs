//! Golden chains: a folder of recorded scenes, each a folder of chains, which are flown again and compared.

use super::chain::{Chain, Stage};
use super::compare::{Parting, compare};
use super::configuration::Named as _;
use super::pair::Common;
use super::record::{Cadence, SHARED, record};
use schuler::flight::configuration::Configuration;
use schuler_simulator::input::name::name_of;
use schuler_simulator::input::{Complaint, InputError, read_text};
use schuler_simulator::navigator::stepping;
use schuler_simulator::scene::{Scene, builtin, limits, parse};
use schuler_simulator::simulate::FlightError;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// The ending of a chain's file.
const ENDING: &str = "chain";

/// What became of one golden chain.
#[derive(Clone, Debug, Serialize)]
pub struct Verdict {
    /// Scene and chain: `paper/f32-local-level-taylor-0-4-0`.
    pub chain: String,
    /// The golden digest of its last stage.
    pub digest: String,
    /// What of it was compared.
    pub held: Common,
    /// Where the flight parts from it.
    pub parting: Option<Parting>,
}

/// The chains below a folder as (name below the folder, path), in order.
pub fn list(folder: &Path) -> Result<Vec<(String, PathBuf)>, InputError> {
    let mut found = Vec::new();
    walk(folder, "", &mut found)?;
    found.sort();
    if found.is_empty() {
        let complaint = Complaint::new(
            "holds no chain",
            "a folder with files *.chain, as schuler audit record writes it",
        );
        return Err(InputError::file(&folder.display().to_string(), complaint));
    }
    Ok(found)
}

fn walk(folder: &Path, name: &str, found: &mut Vec<(String, PathBuf)>) -> Result<(), InputError> {
    let fault = |error: std::io::Error| {
        let complaint = Complaint::new(format!("cannot be read: {error}"), "");
        InputError::file(&folder.display().to_string(), complaint)
    };
    for entry in std::fs::read_dir(folder).map_err(fault)? {
        let path = entry.map_err(fault)?.path();
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let name = if name.is_empty() { stem } else { format!("{name}/{stem}") };
        if path.is_dir() {
            walk(&path, &name, found)?;
        } else if path.extension().is_some_and(|ending| ending == ENDING) {
            found.push((name, path));
        }
    }
    Ok(())
}

/// Where a chain of a scene is kept.
pub fn path(folder: &Path, scene: &str, stem: &str) -> PathBuf {
    folder.join(scene).join(format!("{stem}.{ENDING}"))
}

/// Flies every scene of a folder again and compares each chain; `show` gets every verdict.
pub fn verify(
    folder: &Path,
    show: &mut dyn FnMut(&Verdict) -> Result<(), InputError>,
) -> Result<Vec<Verdict>, FlightError> {
    let mut verdicts = Vec::new();
    let chains = list(folder)?;
    let of_scene = |name: &str| name.rsplit_once('/').map_or(String::new(), |(s, _)| s.to_owned());
    for group in chains.chunk_by(|a, b| of_scene(&a.0) == of_scene(&b.0)) {
        let read = |(name, path): &(String, PathBuf)| {
            let file = name_of(path);
            Ok((name.clone(), Chain::read(&file)?, file))
        };
        let golden: Vec<_> = group.iter().map(read).collect::<Result<_, InputError>>()?;
        let [(_, first, file), ..] = golden.as_slice() else { continue };
        let (scene, cadence) = flight(folder, first, file)?;
        let wanted: Vec<Configuration> = stepping::all()
            .iter()
            .filter(|c| golden.iter().any(|(name, ..)| stem(name) == c.stem()))
            .copied()
            .collect();
        let flown = record(&scene, &wanted, cadence, "")?;
        for (name, golden, file) in &golden {
            if flight(folder, golden, file)? != (scene.clone(), cadence) {
                let what = "is of another flight than the chains beside it";
                let accepted = "scene, duration_s, rate_hz, seed, checkpoint and rows as they have";
                return Err(InputError::file(file, Complaint::new(what, accepted)).into());
            }
            let Some((_, again)) = flown.iter().find(|(flown, _)| flown == stem(name)) else {
                let stems = stepping::all().iter().map(|c| c.stem()).collect::<Vec<_>>();
                let names: Vec<_> = SHARED.map(str::to_owned).into_iter().chain(stems).collect();
                let what = "is not the name of a stage or a navigator that can be flown again";
                return Err(InputError::file(file, Complaint::new(what, names.join(", "))).into());
            };
            whole(golden, again, file)?;
            let (held, parting) = compare(golden, again, file)?;
            let verdict = Verdict { chain: name.clone(), digest: digest(golden), held, parting };
            show(&verdict)?;
            verdicts.push(verdict);
        }
    }
    Ok(verdicts)
}

/// The name of a chain's file, less the ending.
fn stem(name: &str) -> &str {
    name.rsplit('/').next().unwrap_or(name)
}

/// An error unless a golden chain holds every stage of its flight, in all its fields, to the end.
fn whole(golden: &Chain, again: &Chain, file: &str) -> Result<(), InputError> {
    let bad = |what: String, accepted: String| {
        Err(InputError::file(file, Complaint::new(what, accepted)))
    };
    for flown in &again.stages {
        let name = &flown.name;
        let kept = golden.stages.iter().find(|stage| stage.name == *name);
        if kept.map(Stage::line) != Some(flown.line()) {
            let what = match kept {
                None => format!("lacks the stage {name}"),
                Some(_) => format!("its stage {name} has other fields than the flight's"),
            };
            return bad(what, format!("stage: {}", flown.line()));
        }
        let last = flown.last();
        let end = kept.and_then(|stage| stage.end).map(|end| end.sample);
        if end != Some(last) {
            let what = match end {
                None => format!("its stage {name} has no end"),
                Some(sample) => format!("its stage {name} ends at sample {sample}"),
            };
            return bad(what, format!("{name} = {last} DIGEST, where the flight ends"));
        }
    }
    Ok(())
}

/// The digest of a chain's last stage.
pub fn digest(chain: &Chain) -> String {
    let end = chain.stages.iter().rev().find_map(|stage| stage.end);
    end.map_or_else(|| "none".to_owned(), |end| format!("{:016x}", end.digest))
}

/// The scene that a chain was recorded of, as it was flown: a built-in one, or a TOML file in the folder
/// or, where that is a single scene's, beside it.
fn flight(folder: &Path, chain: &Chain, file: &str) -> Result<(Scene, Cadence), InputError> {
    let bad = |key: &str, accepted: &str| {
        let complaint = Complaint::new(format!("{key} is missing or not to be read"), accepted);
        InputError::file(file, complaint)
    };
    let name = chain.get("scene").ok_or_else(|| bad("scene", "scene: NAME"))?;
    let toml = folder.join(format!("{name}.toml"));
    let files = [toml.clone(), folder.join("..").join(format!("{name}.toml"))];
    let mut scene = if let Some(toml) = files.iter().find(|file| file.exists()) {
        let toml = name_of(toml);
        parse::scene(&toml, &read_text(&toml)?)?
    } else {
        let accepted = format!("{}, or a scene that lies in {}", builtin::list(), toml.display());
        builtin::scene(name).ok_or_else(|| bad("scene", &accepted))?
    };
    let number = |key: &str| {
        let value = chain.get(key).and_then(|text| text.parse::<f64>().ok());
        value.ok_or_else(|| bad(key, "a number"))
    };
    let integer = |key: &str| {
        let value = chain.get(key).and_then(|text| text.parse::<u64>().ok());
        value.ok_or_else(|| bad(key, "an integer"))
    };
    scene.duration_s = number("duration_s")?;
    scene.rate_hz = number("rate_hz")?;
    scene.seed = integer("seed")?;
    limits::check(&scene).map_err(|(key, complaint)| {
        InputError::file(file, Complaint::new(format!("{key} {}", complaint.what), ""))
    })?;
    Ok((scene, Cadence { checkpoint: integer("checkpoint")?, rows: integer("rows")? }))
}
