//! A part read back. Whatever is not as it was written is refused, with its place.

use super::super::kept::{Kept, Unfit};
use super::block::Line;
use super::header::{FORM, Header, KIND, hex};
use crate::input::{Complaint, InputError};
use sha2::{Digest as _, Sha256};
use std::fs::File;
use std::io::{self, BufRead as _, BufReader, Read as _};
use std::path::Path;

/// Bytes of a line, at most: so much no line of ours has.
const LONGEST_LINE: u64 = 1 << 28;
/// Bytes of a checksum's line.
const SUM: usize = 65;

/// A part.
#[derive(Clone, Debug)]
pub struct Read {
    /// What it is of.
    pub header: Header,
    /// The runs of its whole blocks.
    pub kept: Kept,
    /// Bytes up to the end of the last whole block.
    pub bytes: u64,
    /// Where it ends within a block, if it does: for people.
    pub torn: Option<String>,
    /// SHA-256 up to there, to go on with.
    pub(super) hash: Sha256,
}

/// Why a block cannot be read.
enum Fault {
    /// The file ends within it.
    Torn,
    /// It is not as it was written.
    Damaged(String),
    /// The file cannot be read.
    Io(io::Error),
}

impl From<io::Error> for Fault {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::UnexpectedEof => Self::Torn,
            _ => Self::Io(error),
        }
    }
}

/// Reads a part. It may end within a block; all other damage is an error.
pub fn read(path: &Path) -> Result<Read, InputError> {
    let refuse = |what: String, accepted: &str| {
        InputError::file(&path.display().to_string(), Complaint::new(what, accepted))
    };
    let unreadable = |error: &io::Error| refuse(format!("cannot be read: {error}"), "");
    let file = File::open(path).map_err(|error| unreadable(&error))?;
    let mut source = Source { file: BufReader::new(file), hash: Sha256::new(), at: 0 };
    let no_part = |why: &str| {
        refuse(format!("is no part of an ensemble: {why}"), "a file of `schuler ensemble --shard`")
    };
    let line = match source.line() {
        Ok(Some(line)) => line,
        Ok(None) => return Err(no_part("it is empty")),
        Err(Fault::Io(error)) => return Err(unreadable(&error)),
        Err(_) => return Err(no_part("its first line has no end")),
    };
    let value: serde_json::Value =
        serde_json::from_slice(&line).map_err(|_| no_part("its first line is not JSON"))?;
    if value["kind"] != KIND {
        return Err(no_part("its first line does not say so"));
    }
    if value["form"] != FORM {
        let what = format!("has the form {} of another version", value["form"]);
        return Err(refuse(what, &FORM.to_string()));
    }
    let header: Header = serde_json::from_value(value)
        .map_err(|error| no_part(&format!("its first line is damaged: {error}")))?;
    let range = header.range();
    if header.shard[0] == 0 || header.shard[0] > header.shard[1] || range.is_empty() {
        return Err(no_part("its first line names no shard"));
    }
    let mut kept = Kept::none(range.start);
    let (mut bytes, mut hash) = (source.at, source.hash.clone());
    let mut torn = None;
    loop {
        let next = kept.runs.end;
        let place = format!("in the block of run {next}, at byte {bytes}");
        match source.block() {
            Ok(None) => break,
            Ok(Some(block)) => {
                if block.runs.end > range.end {
                    let (last, end) = (block.runs.end - 1, range.end - 1);
                    let what = format!("has run {last} {place}, where its shard ends with {end}");
                    return Err(refuse(what, ""));
                }
                kept.join(block).map_err(|unfit| {
                    let what = match unfit {
                        Unfit::Runs { next, first } => format!("has run {first} instead of {next}"),
                        Unfit::Instants => "is read at other instants".to_owned(),
                    };
                    refuse(format!("{what} {place}"), "")
                })?;
                (bytes, hash) = (source.at, source.hash.clone());
            }
            Err(Fault::Torn) => {
                torn = Some(place);
                break;
            }
            Err(Fault::Damaged(what)) => {
                return Err(refuse(format!("is damaged {place}: {what}"), ""));
            }
            Err(Fault::Io(error)) => return Err(unreadable(&error)),
        }
    }
    Ok(Read { header, kept, bytes, torn, hash })
}

struct Source {
    file: BufReader<File>,
    hash: Sha256,
    at: u64,
}

impl Source {
    /// The next block; `None` at the end of the file.
    fn block(&mut self) -> Result<Option<Kept>, Fault> {
        let damaged = |what: &str| Fault::Damaged(what.to_owned());
        let Some(line) = self.line()? else { return Ok(None) };
        let line: Line =
            serde_json::from_slice(&line).map_err(|error| Fault::Damaged(error.to_string()))?;
        let bytes = line.bytes().ok_or_else(|| damaged("its line contradicts itself"))?;
        let mut drifts = Vec::new();
        let taken = self.file.by_ref().take(bytes as u64).read_to_end(&mut drifts)?;
        self.at += taken as u64;
        if taken < bytes {
            return Err(Fault::Torn);
        }
        self.hash.update(&drifts);
        let expected = format!("{}\n", hex(&self.hash.clone().finalize()));
        let mut sum = [0; SUM];
        self.file.read_exact(&mut sum)?;
        self.at += SUM as u64;
        if sum != *expected.as_bytes() {
            return Err(damaged("its bytes have another SHA-256 than the one behind them"));
        }
        self.hash.update(sum);
        line.runs(&drifts).map(Some).ok_or_else(|| damaged("a drift is not finite"))
    }

    /// The next line without its end; `None` at the end of the file.
    fn line(&mut self) -> Result<Option<Vec<u8>>, Fault> {
        let mut line = Vec::new();
        self.file.by_ref().take(LONGEST_LINE).read_until(b'\n', &mut line)?;
        if line.is_empty() {
            return Ok(None);
        }
        if line.last() != Some(&b'\n') {
            return Err(Fault::Torn);
        }
        self.hash.update(&line);
        self.at += line.len() as u64;
        line.pop();
        Ok(Some(line))
    }
}
