//! What is said while somebody listens, instead of being printed: a library prints nothing.

use std::cell::RefCell;

/// What was said.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Heard {
    /// For the output, all of it.
    pub text: String,
    /// Warnings, one by one.
    pub warnings: Vec<String>,
}

thread_local! {
    static EAR: RefCell<Option<Heard>> = const { RefCell::new(None) };
}

/// Ends listening, however the work ends.
struct Listening;

impl Drop for Listening {
    fn drop(&mut self) {
        EAR.with_borrow_mut(|ear| *ear = None);
    }
}

/// Does some work on this thread, and hears what is said.
pub fn overheard<T>(work: impl FnOnce() -> T) -> (T, Heard) {
    EAR.with_borrow_mut(|ear| *ear = Some(Heard::default()));
    let listening = Listening;
    let done = work();
    let heard = EAR.with_borrow_mut(Option::take).unwrap_or_default();
    drop(listening);
    (done, heard)
}

/// Whether somebody listened to a text.
pub(super) fn hears(text: &str) -> bool {
    EAR.with_borrow_mut(|ear| ear.as_mut().map(|heard| heard.text += text)).is_some()
}

/// Says on the error stream what is poor, yet no reason to stop.
pub fn warn(text: &str) {
    let listened =
        EAR.with_borrow_mut(|ear| ear.as_mut().map(|heard| heard.warnings.push(text.to_owned())));
    if listened.is_none() {
        super::say_error(&format!("schuler: warning: {text}"));
    }
}

#[cfg(test)]
mod tests {
    use super::super::say;
    use super::*;

    #[test]
    fn hears_what_is_said_meanwhile_and_nothing_else() {
        let (done, heard) = overheard(|| {
            say("one\n").and_then(|()| say("two\n")).unwrap();
            warn("poor");
            7
        });
        assert_eq!((done, heard.text.as_str()), (7, "one\ntwo\n"));
        assert_eq!(heard.warnings, ["poor"]);
        assert!(!hears("nobody"));
        let broken = std::panic::catch_unwind(|| overheard(|| panic!("broken")));
        assert!(broken.is_err() && !hears("nobody"));
    }
}
