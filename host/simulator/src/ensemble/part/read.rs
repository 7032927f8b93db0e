//! A part read back. Whatever is not as it was written is refused, with its place.

use super::block::{self, Content, Line, Unfit};
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
pub struct Read<C> {
    /// What it is of.
    pub header: Header,
    /// The runs of its whole blocks.
    pub kept: C,
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

/// Reads what a part is of.
pub fn header(path: &Path) -> Result<Header, InputError> {
    Ok(begin(path)?.0)
}

/// Reads a part. It may end within a block; all other damage is an error.
pub fn read<C: Content>(path: &Path) -> Result<Read<C>, InputError> {
    let refuse = |what: String, accepted: &str| refuse(path, what, accepted);
    let (header, mut source) = begin(path)?;
    if header.aided != C::IS_AIDED {
        let [theirs, others] = match header.aided {
            true => ["is of aided runs", "parts of runs that are not"],
            false => ["is of runs without aiding", "parts of aided runs"],
        };
        return Err(refuse(theirs.to_owned(), others));
    }
    let range = header.range();
    let mut kept = C::none(range.start);
    let (mut bytes, mut hash) = (source.at, source.hash.clone());
    let mut torn = None;
    loop {
        let next = kept.runs().end;
        let place = format!("in the block of run {next}, at byte {bytes}");
        match source.block::<C>() {
            Ok(None) => break,
            Ok(Some(block)) => {
                let block_end = block.runs().end;
                if block_end > range.end {
                    let (last, end) = (block_end - 1, range.end - 1);
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
            Err(Fault::Io(error)) => return Err(unreadable(path, &error)),
        }
    }
    Ok(Read { header, kept, bytes, torn, hash })
}

fn refuse(path: &Path, what: String, accepted: &str) -> InputError {
    InputError::file(&path.display().to_string(), Complaint::new(what, accepted))
}

fn unreadable(path: &Path, error: &io::Error) -> InputError {
    refuse(path, format!("cannot be read: {error}"), "")
}

/// Reads the first line.
fn begin(path: &Path) -> Result<(Header, Source), InputError> {
    let file = File::open(path).map_err(|error| unreadable(path, &error))?;
    let mut source = Source { file: BufReader::new(file), hash: Sha256::new(), at: 0 };
    let no_part = |why: &str| {
        let what = format!("is no part of an ensemble: {why}");
        refuse(path, what, "a file of `schuler ensemble --shard`")
    };
    let line = match source.line() {
        Ok(Some(line)) => line,
        Ok(None) => return Err(no_part("it is empty")),
        Err(Fault::Io(error)) => return Err(unreadable(path, &error)),
        Err(_) => return Err(no_part("its first line has no end")),
    };
    let value: serde_json::Value =
        serde_json::from_slice(&line).map_err(|_| no_part("its first line is not JSON"))?;
    if value["kind"] != KIND {
        return Err(no_part("its first line does not say so"));
    }
    if value["form"] != FORM {
        let what = format!("has the form {} of another version", value["form"]);
        return Err(refuse(path, what, &FORM.to_string()));
    }
    let header: Header = serde_json::from_value(value)
        .map_err(|error| no_part(&format!("its first line is damaged: {error}")))?;
    if header.shard[0] == 0 || header.shard[0] > header.shard[1] || header.range().is_empty() {
        return Err(no_part("its first line names no shard"));
    }
    Ok((header, source))
}

struct Source {
    file: BufReader<File>,
    hash: Sha256,
    at: u64,
}

impl Source {
    /// The next block; `None` at the end of the file.
    fn block<C: Content>(&mut self) -> Result<Option<C>, Fault> {
        let damaged = |what: &str| Fault::Damaged(what.to_owned());
        let Some(line) = self.line()? else { return Ok(None) };
        let line: Line =
            serde_json::from_slice(&line).map_err(|error| Fault::Damaged(error.to_string()))?;
        let bytes = line.bytes::<C>().ok_or_else(|| damaged("its line contradicts itself"))?;
        let mut numbers = Vec::new();
        let taken = self.file.by_ref().take(bytes as u64).read_to_end(&mut numbers)?;
        self.at += taken as u64;
        if taken < bytes {
            return Err(Fault::Torn);
        }
        self.hash.update(&numbers);
        let expected = format!("{}\n", hex(&self.hash.clone().finalize()));
        let mut sum = [0; SUM];
        self.file.read_exact(&mut sum)?;
        self.at += SUM as u64;
        if sum != *expected.as_bytes() {
            return Err(damaged("its bytes have another SHA-256 than the one behind them"));
        }
        self.hash.update(sum);
        block::runs(line, &numbers).map(Some).ok_or_else(|| damaged("a number is not finite"))
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
