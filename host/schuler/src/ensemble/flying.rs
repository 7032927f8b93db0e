//! The flight of an ensemble or of a shard: from its beginning, or from where it was stopped.

use crate::cli::{EnsembleArgs, Shard};
use schuler_simulator::ensemble::batches::{self, Means};
use schuler_simulator::ensemble::group::Ground;
use schuler_simulator::ensemble::kept::Kept;
use schuler_simulator::ensemble::part::block::Content;
use schuler_simulator::ensemble::part::header::Header;
use schuler_simulator::ensemble::part::read::{self, Read};
use schuler_simulator::ensemble::part::write::Writer;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::say_error;
use schuler_simulator::progress::Progress;
use schuler_simulator::simulate::FlightError;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The runs of a part that has been flown.
pub struct Flown<C> {
    /// What is kept of them.
    pub kept: C,
    /// How many were flown now, and how long that took.
    pub now: (u64, Duration),
}

/// Where the part of an ensemble or of one of its shards lies.
pub fn part(folder: &Path, shard: Option<Shard>) -> PathBuf {
    match shard {
        None => folder.join("ensemble.part"),
        Some(Shard([k, n])) => folder.join(format!("shard-{k}-of-{n}.part")),
    }
}

/// A part to be flown, with what has been flown of it.
pub struct Begun<C> {
    path: PathBuf,
    header: Header,
    earlier: Option<Read<C>>,
    /// Whether results follow at once, so that the last batch need not be saved.
    is_whole: bool,
}

impl<C: Content> Begun<C> {
    /// What is there of a part. One that is there must be gone on with; one of another ensemble cannot be.
    pub fn new(args: &EnsembleArgs, path: PathBuf, header: Header) -> Result<Self, InputError> {
        let refuse = |what: String, accepted: &str| {
            InputError::file(&path.display().to_string(), Complaint::new(what, accepted))
        };
        let is_whole = args.shard.is_none();
        if !path.exists() {
            return Ok(Self { path, header, earlier: None, is_whole });
        }
        if !args.resume {
            let what = "is there from before".to_owned();
            return Err(refuse(what, "--resume, which goes on with it, or another --out"));
        }
        let earlier = read::read(&path)?;
        let (theirs, ours) = (earlier.header.shard, header.shard);
        if theirs != ours {
            let what = format!("is shard {} of {}", theirs[0], theirs[1]);
            return Err(refuse(what, &format!("shard {} of {}", ours[0], ours[1])));
        }
        if let Some(difference) = earlier.header.difference(&header) {
            return Err(refuse(difference, "the options that it was begun with, or another --out"));
        }
        if let Some(torn) = &earlier.torn {
            let path = path.display();
            say_error(&format!("schuler: {path} ends {torn}: these runs are flown again"));
        }
        Ok(Self { path, header, earlier: Some(earlier), is_whole })
    }

    /// The runs that are left.
    pub fn left(&self) -> Range<u64> {
        let range = self.header.range();
        self.earlier.as_ref().map_or(range.start, |read| read.kept.runs().end)..range.end
    }

    /// Flies them: `fly` has the runs and hands each batch of them on. All batches are added to the part; of a whole
    /// ensemble all but the last, whose results follow at once.
    pub fn fly(
        self,
        fly: impl FnOnce(
            Range<u64>,
            &mut dyn FnMut(C) -> Result<(), FlightError>,
        ) -> Result<(), FlightError>,
    ) -> Result<Flown<C>, FlightError> {
        let left = self.left();
        let Self { path, header, earlier, is_whole } = self;
        let mut writer = match &earlier {
            Some(read) if !left.is_empty() => Writer::resume(&path, read)?,
            // What is complete stays as it is.
            _ => Writer::create(&path, &header)?,
        };
        let mut kept = earlier.map_or(C::none(left.start), |read| read.kept);
        let begin = Instant::now();
        fly(left.clone(), &mut |batch| {
            if !(is_whole && batch.runs().end == left.end) {
                writer.add(&batch)?;
            }
            // Batches of one flight follow one another.
            let _ = kept.join(batch);
            Ok(())
        })?;
        Ok(Flown { kept, now: (left.end - left.start, begin.elapsed()) })
    }
}

/// Flies the runs of an ensemble that is compared with theory.
pub fn fly(begun: Begun<Kept>, ground: &Ground, means: Means) -> Result<Flown<Kept>, FlightError> {
    begun.fly(|left, done| {
        let progress = Progress::new(ground.scene.samples() * (left.end - left.start));
        // The bar moves at whole blocks of samples only.
        let reach = |samples: u64| progress.reach(samples / 4096 * 4096);
        batches::fly(ground, left, means, &reach, done)?;
        progress.finish();
        Ok(())
    })
}
