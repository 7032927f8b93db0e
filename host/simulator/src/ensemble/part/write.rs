//! A part that grows by whole blocks.

use super::block::{self, Content};
use super::header::{Header, hex};
use super::read::Read;
use crate::input::{Complaint, InputError};
use crate::output::GrowingFile;
use serde::Serialize;
use sha2::{Digest as _, Sha256};
use std::path::Path;

/// A part under way.
#[derive(Debug)]
pub struct Writer {
    file: GrowingFile,
    /// Bytes of the first line, which go with the first block.
    start: Vec<u8>,
    hash: Sha256,
    header: Header,
}

impl Writer {
    /// A new one. Nothing is made before the first block.
    pub fn create(path: &Path, header: &Header) -> Result<Self, InputError> {
        let start = line(path, header)?;
        let hash = Sha256::new_with_prefix(&start);
        Ok(Self { file: GrowingFile::create(path)?, start, hash, header: header.clone() })
    }

    /// One that goes on behind the last whole block of what was read.
    pub fn resume(path: &Path, read: &Read<impl Content>) -> Result<Self, InputError> {
        let file = GrowingFile::resume(path, read.bytes)?;
        Ok(Self { file, start: Vec::new(), hash: read.hash.clone(), header: read.header.clone() })
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        self.file.path()
    }

    /// Adds runs.
    pub fn add(&mut self, runs: &impl Content) -> Result<(), InputError> {
        let mut bytes = std::mem::take(&mut self.start);
        let begun = bytes.len();
        bytes.extend(line(self.path(), &runs.line())?);
        bytes.extend(block::bytes(runs));
        self.hash.update(&bytes[begun..]);
        let sum = format!("{}\n", hex(&self.hash.clone().finalize()));
        self.hash.update(&sum);
        bytes.extend(sum.as_bytes());
        let range = self.header.range();
        let (done, all) = (runs.runs().end - range.start, range.end - range.start);
        let path = self.path().display();
        let left = format!("{path} holds {done} of {all} runs; --resume goes on with it");
        self.file.append(&bytes, left)
    }
}

/// JSON on a line.
fn line(path: &Path, value: &impl Serialize) -> Result<Vec<u8>, InputError> {
    let mut line = serde_json::to_vec(value).map_err(|error| {
        let complaint = Complaint::new(format!("cannot be written: {error}"), "");
        InputError::file(&path.display().to_string(), complaint)
    })?;
    line.push(b'\n');
    Ok(line)
}
