//! Chain files, read line by line.

use super::chain::{Chain, Checkpoint, MAGIC, Row, Stage, Width};
use schuler_simulator::input::{Complaint, InputError, read_text};

impl Chain {
    /// From a file.
    pub fn read(file: &str) -> Result<Self, InputError> {
        Self::parse(file, &read_text(file)?)
    }

    /// From a text; `file` names it in errors.
    pub fn parse(file: &str, text: &str) -> Result<Self, InputError> {
        let mut chain = Self::default();
        let mut lines = (1..).zip(text.lines().map(str::trim_end));
        let bad = |line: u64, what: &str, accepted: &str| {
            InputError::line(file, line, Complaint::new(what, accepted))
        };
        if lines.next().is_none_or(|(_, line)| line != MAGIC) {
            return Err(bad(1, "is not a chain", &format!("the first line \"{MAGIC}\"")));
        }
        for (number, line) in lines.by_ref() {
            if line.is_empty() {
                break;
            }
            let Some((key, value)) = line.split_once(": ") else {
                return Err(bad(
                    number,
                    "is not a line of the head",
                    "key: value, or a blank line",
                ));
            };
            if key == "stage" {
                let stage = Stage::parse(value)
                    .ok_or_else(|| bad(number, "is not a stage", "stage: NAME f32|f64 FIELD …"))?;
                if chain.stages.iter().any(|other| other.name == stage.name) {
                    let what = format!("is a second stage of the name {}", stage.name);
                    return Err(bad(number, &what, "a name for each stage"));
                }
                chain.stages.push(stage);
            } else {
                chain.about.push((key.to_owned(), value.to_owned()));
            }
        }
        for (number, line) in lines {
            let (name, rest) = line.split_once(' ').unwrap_or((line, ""));
            let Some(place) = chain.stages.iter().position(|stage| stage.name == name) else {
                let names: Vec<_> = chain.stages.iter().map(|stage| stage.name.as_str()).collect();
                let names = names.join(", ");
                return Err(bad(number, "does not begin with the name of a stage", &names));
            };
            let stage = &mut chain.stages[place];
            if let Some(Checkpoint { sample, .. }) = stage.end {
                let what = format!("comes after the end of the stage {name}, at sample {sample}");
                return Err(bad(number, &what, "one = line for a stage, its last"));
            }
            if stage.take(rest).is_none() {
                let what = format!("{} samples, in order, and words", stage.name);
                let digits = stage.width.digits();
                let accepted = format!(
                    "SAMPLE and {} words of {digits} hexadecimal digits, or # or = SAMPLE and a \
                     digest of 16; samples ascend, and the end is no other than a checkpoint there",
                    stage.fields.len()
                );
                return Err(bad(number, &format!("is not a row of {what}"), &accepted));
            }
        }
        Ok(chain)
    }
}

impl Stage {
    fn parse(text: &str) -> Option<Self> {
        let mut words = text.split_whitespace();
        let name = words.next()?;
        let width = [Width::Single, Width::Double];
        let kind = words.next()?;
        let mut stage = Self::new(name, width.into_iter().find(|w| w.name() == kind)?);
        stage.fields = words.map(str::to_owned).collect();
        Some(stage)
    }

    /// Takes a line after the stage's name.
    fn take(&mut self, line: &str) -> Option<()> {
        let mut words = line.split_whitespace();
        let first = words.next()?;
        if first == "#" || first == "=" {
            let sample = words.next()?.parse().ok()?;
            let digest = hex(words.next()?, 16)?;
            let checkpoint = Checkpoint { sample, digest };
            if first == "=" {
                let row = self.rows.last().map(|row| row.sample);
                let before = self.checkpoints.last().filter(|last| **last != checkpoint);
                let before = before.map(|last| last.sample.saturating_add(1));
                row.max(before).is_none_or(|least| least <= sample).then_some(())?;
                self.end = Some(checkpoint);
            } else {
                ascends(self.checkpoints.last().map(|c| c.sample), sample)?;
                self.checkpoints.push(checkpoint);
            }
            return words.next().is_none().then_some(());
        }
        let sample = first.parse().ok()?;
        ascends(self.rows.last().map(|row| row.sample), sample)?;
        let words: Option<Vec<_>> = words.map(|word| hex(word, self.width.digits())).collect();
        let words = words.filter(|words| words.len() == self.fields.len())?;
        self.rows.push(Row { sample, words });
        Some(())
    }
}

fn ascends(last: Option<u64>, next: u64) -> Option<()> {
    last.is_none_or(|last| last < next).then_some(())
}

fn hex(text: &str, digits: usize) -> Option<u64> {
    let plain = text.len() == digits && text.bytes().all(|b| b.is_ascii_hexdigit());
    plain.then(|| u64::from_str_radix(text, 16).ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "schuler chain 1\nscene: paper\nstage: noise f64 angle_b\n\
        stage: nav f32 v v v\n\nnoise 1 3ff0000000000000\nnav 1 3f800000 00000000 bf000000\n\
        nav # 1 0123456789abcdef\nnoise = 1 00000000000000ff\nnav = 1 0123456789abcdef\n";

    #[test]
    fn reads_what_it_writes() {
        let chain = Chain::parse("a", TEXT).unwrap();
        assert_eq!(chain.text(), TEXT);
        assert_eq!(chain.get("scene"), Some("paper"));
        let nav = &chain.stages[1];
        assert_eq!(nav.rows[0].words, [0x3f80_0000, 0, 0xbf00_0000]);
        assert_eq!((nav.label(0, None), nav.label(2, None)), ("v 1".into(), "v 3".into()));
        assert_eq!(nav.end, Some(Checkpoint { sample: 1, digest: 0x0123_4567_89ab_cdef }));
    }

    #[test]
    fn names_the_line_that_is_wrong() {
        for (from, to, line) in [
            ("schuler chain 1", "schuler chain 2", 1),
            ("scene: paper", "scene paper", 2),
            ("f64 angle_b", "f16 angle_b", 3),
            ("noise 1", "nose 1", 6),
            ("3ff0000000000000", "3ff", 6),
            ("bf000000", "bf00000g", 7),
            (" bf000000", "", 7),
            ("nav # 1 0123", "nav # 1 012", 8),
            ("= 1 00000000000000ff", "= 1 00000000000000ff 1", 9),
            ("nav = 1 0123456789abcdef", "nav = 1 0123456789abcdee", 10),
            ("nav = 1", "nav = 0", 10),
            ("noise = 1", "noise = 0", 9),
        ] {
            let error = Chain::parse("a", &TEXT.replacen(from, to, 1)).unwrap_err();
            assert_eq!(error.line, Some(line), "{error}");
        }
    }

    #[test]
    fn tells_what_it_would_take() {
        for (from, to, line, words) in [
            ("noise 1", "nose 1", 6, "accepted: noise, nav"),
            ("stage: nav f32", "stage: noise f32", 4, "is a second stage of the name noise"),
            (
                "nav = 1",
                "noise = 1",
                10,
                "comes after the end of the stage noise, at sample 1; accepted: one = line",
            ),
            (
                "nav = 1",
                "noise 2 0000000000000000\nnav = 1",
                10,
                "after the end of the stage noise",
            ),
        ] {
            let error = Chain::parse("a", &TEXT.replacen(from, to, 1)).unwrap_err();
            assert_eq!(error.line, Some(line), "{error}");
            assert!(error.to_string().contains(words), "{error}");
        }
    }
}
