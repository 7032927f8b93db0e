//! The target's application behind standard input and output: the other end of `--device twin`.

use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::twin::application;
use std::io::{self, Read, Write};

/// Serves until the input ends.
pub fn serve() -> Result<(), InputError> {
    let fault = |error: io::Error| {
        let what = format!("the line to the host has ended: {error}");
        InputError::option("twin", Complaint::new(what, ""))
    };
    let (mut from, mut to) = (io::stdin().lock(), io::stdout().lock());
    let (mut buffer, mut answers) = ([0; 4096], Vec::new());
    let mut target = application::every();
    target.hello(&mut |bytes| answers.extend_from_slice(bytes));
    loop {
        to.write_all(&answers).and_then(|()| to.flush()).map_err(fault)?;
        answers.clear();
        let length = from.read(&mut buffer).map_err(fault)?;
        if length == 0 {
            return Ok(());
        }
        target.take(&buffer[..length], &mut |bytes| answers.extend_from_slice(bytes));
    }
}
