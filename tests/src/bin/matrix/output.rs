//! What the audit program prints: digests, line by line.

use schuler::digest::Digest;

/// Everything that one target printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    text: String,
}

/// A line of it: `paper/f32-local-level-textbook nav 64 0123456789abcdef`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line<'a> {
    /// Scene and configuration, or scene and stage.
    pub flight: &'a str,
    /// The stage.
    pub stage: &'a str,
    /// The samples behind it, after `=` if they are all.
    pub sample: &'a str,
    /// The digest of all rows up to there.
    pub digest: &'a str,
}

impl<'a> Line<'a> {
    fn parse(line: &'a str) -> Option<Self> {
        let mut words = line.split(' ');
        let (flight, stage) = (words.next()?, words.next()?);
        let (sample, digest) = (words.next()?, words.next()?);
        let well = words.next().is_none() && u64::from_str_radix(digest, 16).is_ok();
        well.then_some(Self { flight, stage, sample, digest })
    }

    /// Where it stands, for people.
    pub fn place(&self) -> String {
        let sample = self.sample.trim_start_matches('=');
        format!("{}, stage {}, by sample {sample}", self.flight, self.stage)
    }
}

impl Output {
    /// From the text of a target; an error names the first line that is no digest.
    pub fn parse(text: String) -> Result<Self, String> {
        if let Some(line) = text.lines().find(|line| Line::parse(line).is_none()) {
            return Err(format!("prints \"{line}\", which is no digest"));
        }
        if text.is_empty() {
            return Err("prints nothing".to_owned());
        }
        Ok(Self { text })
    }

    /// Its lines, in order.
    pub fn lines(&self) -> impl Iterator<Item = Line<'_>> {
        self.text.lines().filter_map(Line::parse)
    }

    /// One digest over all of it.
    pub fn digest(&self) -> String {
        let mut digest = Digest::default();
        digest.add_words(self.text.bytes().map(u64::from));
        format!("{:016x}", digest.value())
    }

    /// Where another output first differs from this; `None` if it is the same.
    pub fn parts(&self, other: &Self) -> Option<String> {
        let mut others = other.lines();
        for line in self.lines() {
            match others.next() {
                Some(theirs) if theirs == line => {}
                Some(theirs) if Line { digest: line.digest, ..theirs } == line => {
                    return Some(line.place());
                }
                _ => return Some(format!("{} is not printed", line.place())),
            }
        }
        others.next().map(|line| format!("{} is printed besides", line.place()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str =
        "paper/noise noise 64 0000000000000001\npaper/noise noise =70 00000000000000ff\n";

    fn output(text: &str) -> Output {
        Output::parse(text.to_owned()).unwrap()
    }

    #[test]
    fn the_first_line_that_differs_is_named() {
        let one = output(TEXT);
        assert_eq!(one.parts(&one), None);
        let other = output(&TEXT.replace("00ff", "00fe"));
        assert_eq!(one.parts(&other).unwrap(), "paper/noise, stage noise, by sample 70");
        assert_ne!(one.digest(), other.digest());
        for (from, to) in [(" noise 64", " nav 64"), ("paper/", "hard/"), ("=70", "=71")] {
            let parts = one.parts(&output(&TEXT.replace(from, to))).unwrap();
            assert!(parts.ends_with("is not printed"), "{to}: {parts}");
        }
        let short = output(TEXT.lines().next().unwrap());
        assert_eq!(
            one.parts(&short).unwrap(),
            "paper/noise, stage noise, by sample 70 is not printed"
        );
        assert!(short.parts(&one).unwrap().ends_with("is printed besides"));
    }

    #[test]
    fn what_is_no_digest_is_refused() {
        for text in ["", "hello", "paper/noise noise 64 xyz", "paper/noise noise 64 0 0"] {
            assert!(Output::parse(text.to_owned()).is_err(), "{text}");
        }
    }
}
