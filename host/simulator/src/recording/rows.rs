//! A recording's file, read from its start as often as needed, a row at a time.

use super::foreign::{self, Given, Parts, PartsReader};
use super::instant::Scale;
use super::lines::{self, Lines};
use super::navigation::NavigationRow;
use super::reduction::Reduction;
use super::{Kind, Row, Unread, csv, psins};
use crate::input::name::path_of;
use crate::input::{Complaint, InputError};
use crate::rest::units::{TimeUnit, Units};
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use std::fs::File;

/// A file of samples, not yet read beyond what stands before them.
#[derive(Debug)]
pub struct Recording {
    /// Its name, for errors about its samples.
    pub name: String,
    /// What its rows hold, or are said to hold.
    pub kind: Kind,
    /// The sample interval that the file itself states, s.
    pub interval_s: Option<f64>,
    /// The state that the file itself says it starts from.
    pub initial: Option<NavigationRow>,
    /// How its times are written; absent where their look decides.
    pub time: Option<TimeUnit>,
    /// What its times are counted from, where that is known.
    pub scale: Option<Scale>,
    /// What was found in opening it, a line each.
    pub said: Vec<String>,
    layout: Layout,
    reduction: Reduction,
}

/// How rows are written.
#[derive(Debug)]
enum Layout {
    /// One file in a layout of its own, from where its rows begin.
    Own { file: File, own: Own, begins: (u64, u64) },
    /// By a map.
    Mapped(Parts),
}

#[derive(Clone, Copy, Debug)]
enum Own {
    Csv(&'static [&'static str; 7]),
    Psins(psins::Settings),
}

impl Recording {
    /// From a file or a folder whose content is known: our own CSV, a PSINS `.imu`, a format of `formats`, or numbers
    /// that tell their columns.
    pub fn open(name: &str) -> Result<Self, InputError> {
        Self::open_as(name, &Given::default())
    }

    /// The same, its numbers in units of their own.
    pub fn open_in(name: &str, units: Units) -> Result<Self, InputError> {
        Self::open_as(name, &Given { units, ..Given::default() })
    }

    /// The same with all that is said of it.
    pub fn open_as(name: &str, given: &Given) -> Result<Self, InputError> {
        let file = if path_of(name).is_dir() { None } else { Some(lines::open(name)?) };
        Self::new(name, file, given)
    }

    /// From a text; `name` stands for it in errors.
    pub fn of_text(name: &str, text: &str) -> Result<Self, InputError> {
        Self::new(name, Some(lines::spooled(name, text)?), &Given::default())
    }

    fn new(name: &str, file: Option<File>, given: &Given) -> Result<Self, InputError> {
        let mapped = given.map.is_some() || given.columns.is_some();
        let mut file = file;
        if let Some(own) = file.take_if(|_| !mapped) {
            match Self::own(name, own, given)? {
                Ok(recording) => return Ok(recording),
                Err(other) => file = Some(other),
            }
        }
        let opened = foreign::open(name, file.as_ref(), given)?;
        Ok(Self {
            name: opened.parts.name().to_owned(),
            kind: opened.kind,
            interval_s: opened.interval_s,
            initial: None,
            time: opened.time,
            scale: opened.scale,
            said: opened.said,
            layout: Layout::Mapped(opened.parts),
            reduction: opened.reduction,
        })
    }

    /// A file in a layout of its own, or the file again.
    fn own(name: &str, file: File, given: &Given) -> Result<Result<Self, File>, InputError> {
        let mut lines = Lines::new(name, &file, (0, 0))?;
        if !lines.next_filled()? {
            return Err(InputError::file(name, Complaint::new("is empty", csv::accepted())));
        }
        let mut recording = Self {
            name: name.to_owned(),
            kind: Kind::Increments,
            interval_s: None,
            initial: None,
            time: given.units.time,
            scale: None,
            said: Vec::new(),
            layout: Layout::Mapped(Parts::none()),
            reduction: Reduction {
                units: given.units,
                mounting: given.axes,
                ..Reduction::default()
            },
        };
        let own = if let Some(columns) = csv::columns(lines.text()) {
            if *columns == csv::RATES {
                recording.kind = Kind::Rates;
            }
            Own::Csv(columns)
        } else if psins::is_one(&mut Lines::new(name, &file, (0, 0))?)? {
            let (settings, initial) = psins::settings(name, &mut lines)?;
            let stated = [
                (given.units.kind == Some(Kind::Rates), "--units", "units without rates"),
                (given.units.time.is_some(), "--units", "units without one of time"),
                (given.axes.is_some(), "--axes", "none: its axes are right-forward-up"),
            ];
            if let Some((_, option, accepted)) = stated.into_iter().find(|(wrong, ..)| *wrong) {
                let complaint =
                    Complaint::new("contradicts a PSINS .imu, which holds increments", accepted);
                return Err(InputError::option(option, complaint));
            }
            recording.interval_s = Some(settings.interval_s);
            recording.initial = Some(initial);
            Own::Psins(settings)
        } else {
            return Ok(Err(file));
        };
        recording.kind = given.units.kind.unwrap_or(recording.kind);
        recording.layout = Layout::Own { file, own, begins: lines.place() };
        Ok(Ok(recording))
    }

    /// Its rows from the first one.
    pub fn rows(&self) -> Result<Rows, InputError> {
        let source = match &self.layout {
            Layout::Own { file, own, begins } => Source::Own {
                lines: Box::new(Lines::new(&self.name, file, *begins)?),
                own: *own,
                before: Vec::new(),
                read: 0,
            },
            Layout::Mapped(parts) => Source::Mapped(parts.reader()?),
        };
        Ok(Rows { source, reduction: self.reduction, kind: self.kind })
    }

    /// What known biases add to increments, per second of their interval.
    pub fn bias_per_second(&self) -> Option<Increment<f64>> {
        self.reduction.per_second(self.kind)
    }

    /// An error about one of its lines.
    pub fn error(&self, line: u64, complaint: Complaint) -> InputError {
        InputError::line(&self.name, line, complaint)
    }
}

/// The rows of a recording, in the order of its lines.
#[derive(Debug)]
pub struct Rows {
    source: Source,
    reduction: Reduction,
    kind: Kind,
}

/// Where rows come from.
#[derive(Debug)]
enum Source {
    Own { lines: Box<Lines>, own: Own, before: Vec<u8>, read: u64 },
    Mapped(PartsReader),
}

impl Rows {
    /// The next row, whole or its stamp alone; a line that is none; or the end. An error is one of the file.
    pub fn next(&mut self, whole: bool) -> Result<Option<Result<Row, Unread>>, InputError> {
        let row = match &mut self.source {
            Source::Own { lines, own, before, read } => own.next(lines, before, read, whole)?,
            Source::Mapped(reader) => reader.next(whole)?.map(|taken| {
                taken.map(|taken| {
                    let [a, b, c, u, v, w] = taken.values;
                    let (angle_b, velocity_b) = (Vector::new(a, b, c), Vector::new(u, v, w));
                    let values = Increment { angle_b, velocity_b };
                    Row { stamp: taken.stamp, line: taken.line, values, repeated: taken.repeated }
                })
            }),
        };
        let reduced =
            |row: Row| Row { values: self.reduction.apply(&row.values, self.kind), ..row };
        Ok(row.map(|row| if whole { row.map(reduced) } else { row }))
    }
}

impl Own {
    fn next(
        self,
        lines: &mut Lines,
        before: &mut Vec<u8>,
        read: &mut u64,
        whole: bool,
    ) -> Result<Option<Result<Row, Unread>>, InputError> {
        loop {
            if !lines.next_filled()? {
                return Ok(None);
            }
            if !(matches!(self, Self::Psins(_)) && lines.text()[0] == b'%') {
                break;
            }
        }
        *read += 1;
        let (name, line) = (&lines.name, lines.number);
        let text = lines.text();
        let parsed = match self {
            Self::Csv(columns) => csv::row(name, line, columns, text, whole),
            Self::Psins(settings) => settings.row(name, line, *read, text, whole),
        };
        let repeated = before == text;
        if !repeated {
            before.clear();
            before.extend_from_slice(text);
        }
        Ok(Some(parsed.map(|(stamp, values)| Row { stamp, line, values, repeated })))
    }
}
