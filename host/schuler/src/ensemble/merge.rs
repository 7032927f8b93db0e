//! `schuler ensemble merge`: the whole of an ensemble from its parts.

use super::aided;
use super::conclusion::{Conclusion, Merged, threads};
use super::files::Extra;
use crate::cli::{EnsembleArgs, MergeArgs};
use crate::report::head::shell;
use schuler_simulator::ensemble::batches::Means;
use schuler_simulator::ensemble::group::Ground;
use schuler_simulator::ensemble::kept::Kept;
use schuler_simulator::ensemble::part::block::Content;
use schuler_simulator::ensemble::part::header::Header;
use schuler_simulator::ensemble::part::read::{self, Read};
use schuler_simulator::input::name::name_of;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::scene::Scene;
use schuler_simulator::simulate::FlightError;
use schuler_simulator::source::Source;
use std::path::{Path, PathBuf};

/// Reads the parts, checks that they are one ensemble, and concludes as if it had been flown at once.
pub fn merge(args: &MergeArgs) -> Result<(), FlightError> {
    match args.parts.first().map(|first| read::header(first)).transpose()? {
        Some(header) if header.aided => merge_as(args, aided::conclude),
        _ => merge_as(args, conclude),
    }
}

fn merge_as<C: Content>(
    args: &MergeArgs,
    conclude: impl FnOnce(Merged, C) -> Result<(), FlightError>,
) -> Result<(), FlightError> {
    let parts = parts::<C>(&args.parts)?;
    let Some((first, head)) = parts.first().map(|(path, read)| (path.clone(), read.header.clone()))
    else {
        let complaint = Complaint::new("there is none", "the parts of an ensemble");
        return Err(InputError::option("PART", complaint).into());
    };
    let (whole, scene) = scene(args, &first, &head)?;
    let source = Source::new(&scene, false)?;
    let ground = Ground::new(&scene, &source);
    let stops = super::stops(&ground, &whole.at);
    let here = Header::new(&ground, head.command.clone(), head.runs, head.shard, &stops);
    if let Some(difference) = head.difference(&here) {
        let accepted = "the scene as it was flown; --scene names it where it is elsewhere";
        return Err(refuse(&first, difference, accepted).into());
    }
    let mut kept = C::none(0);
    for (path, read) in parts {
        kept.join(read.kept).map_err(|_| {
            refuse(&path, "does not follow the shard before it".to_owned(), "parts of one ensemble")
        })?;
    }
    conclude(Merged { args, whole: &whole, ground: &ground, stops: &stops }, kept)
}

fn conclude(merged: Merged, kept: Kept) -> Result<(), FlightError> {
    let Merged { args, whole, ground, stops } = merged;
    let unit = ground.widest(kept.runs.end);
    let threads = threads(args.threads, unit, kept.runs.end);
    let conclusion = Conclusion {
        ground,
        whole,
        means: Means { unit, threads, stops, batch: None },
        extra: Extra { keep: args.keep, svg: args.svg },
        budget: args.budget,
        folder: super::folder(args.out.as_deref(), ground.scene),
    };
    // A file that cannot be written is found before the work.
    let files = conclusion.files()?;
    conclusion.conclude(files, kept, String::new(), &[])
}

/// The parts in order: all of one ensemble, each once, none missing, each complete.
fn parts<C: Content>(paths: &[PathBuf]) -> Result<Vec<(PathBuf, Read<C>)>, InputError> {
    let mut parts: Vec<(PathBuf, Read<C>)> = Vec::new();
    for path in paths {
        let part = read::read::<C>(path)?;
        if let Some((first, other)) = parts.first()
            && let Some(difference) = part.header.difference(&other.header)
        {
            let what = format!("{difference} ({})", first.display());
            return Err(refuse(path, what, "parts of one ensemble"));
        }
        let [k, n] = part.header.shard;
        let range = part.header.range();
        let (done, all) = (part.kept.runs().end - range.start, range.end - range.start);
        if let Some(torn) = &part.torn {
            let what = format!("ends {torn}: it holds {done} of {all} runs of shard {k} of {n}");
            return Err(refuse(path, what, &resume(&part.header, path)));
        }
        if done < all {
            let what = format!("holds {done} of {all} runs of shard {k} of {n}");
            return Err(refuse(path, what, &resume(&part.header, path)));
        }
        if let Some((twin, _)) = parts.iter().find(|(_, other)| other.header.shard[0] == k) {
            let what = format!("is shard {k} of {n}, and so is {}", twin.display());
            return Err(refuse(path, what, "each shard once"));
        }
        parts.push((path.clone(), part));
    }
    parts.sort_by_key(|(_, part)| part.header.shard[0]);
    let shards = parts.first().map_or(0, |(_, part)| part.header.shard[1]);
    let is_there = |k: &u64| parts.iter().any(|(_, part)| part.header.shard[0] == *k);
    let missing: Vec<String> =
        (1..=shards).filter(|k| !is_there(k)).map(|k| k.to_string()).collect();
    if !missing.is_empty() {
        let (some, more) = missing.split_at(missing.len().min(20));
        let more =
            if more.is_empty() { String::new() } else { format!(" and {} more", more.len()) };
        let shard = if missing.len() == 1 { "shard" } else { "shards" };
        let what = format!("of {shards} shards there is no {shard} {}{more}", some.join(", "));
        return Err(InputError::option("PART", Complaint::new(what, "all shards of an ensemble")));
    }
    Ok(parts)
}

/// The command that completes a part where it lies.
fn resume(header: &Header, part: &Path) -> String {
    let [k, n] = header.shard;
    let mut command = header.command.clone();
    if n > 1 {
        command.extend(["--shard".to_owned(), format!("{k}/{n}")]);
    }
    let folder = part.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new("."));
    command.extend(["--resume".to_owned(), "--out".to_owned(), name_of(folder)]);
    format!("what `schuler {}` makes of it", shell(&command))
}

/// The command of the whole, and its scene.
fn scene(
    args: &MergeArgs,
    part: &Path,
    header: &Header,
) -> Result<(EnsembleArgs, Scene), InputError> {
    let Some(mut whole) = EnsembleArgs::of_whole(&header.command) else {
        let what = format!("says `schuler {}`, which is no ensemble", header.command.join(" "));
        return Err(refuse(part, what, "a part of this version of schuler"));
    };
    let own = whole.clone();
    if args.scene.is_some() {
        whole.scene.clone_from(&args.scene);
    }
    let scene = whole.scene().map_err(|error| {
        let what = format!("was flown with a scene that cannot be read here: {error}");
        refuse(part, what, "--scene with the place of its file")
    })?;
    Ok((own, scene))
}

fn refuse(path: &Path, what: String, accepted: &str) -> InputError {
    InputError::file(&path.display().to_string(), Complaint::new(what, accepted))
}
