//! How the lines of a text file are cut into fields.

use csv_core::ReadRecordResult;

/// How the lines of the files are written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Text {
    /// What stands between fields; absent where a line's look decides.
    pub delimiter: Option<Delimiter>,
    /// What begins a comment; absent for #, % and //.
    pub comment: Option<String>,
    /// Lines at the top that are passed over.
    pub skip_lines: u64,
}

/// What stands between the fields of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delimiter {
    /// One such byte.
    Byte(u8),
    /// Blanks, any number of them.
    Blanks,
}

impl Delimiter {
    /// What maps call them.
    pub const NAMES: &'static [(&'static str, Self)] = &[
        (",", Self::Byte(b',')),
        (";", Self::Byte(b';')),
        ("|", Self::Byte(b'|')),
        ("tab", Self::Byte(b'\t')),
        ("blanks", Self::Blanks),
    ];

    /// The one that a line looks to have: of commas, semicolons, bars and tabs the most frequent, else blanks.
    pub fn of(line: &[u8]) -> Self {
        let count = |delimiter: u8| line.iter().filter(|&&byte| byte == delimiter).count();
        let most = [b'|', b'\t', b';', b','].into_iter().max_by_key(|&delimiter| count(delimiter));
        match most.filter(|&delimiter| count(delimiter) > 0) {
            Some(delimiter) => Self::Byte(delimiter),
            None => Self::Blanks,
        }
    }
}

/// Marks that begin a comment where nothing is stated.
const MARKS: [&[u8]; 3] = [b"#", b"%", b"//"];

/// A comment without the mark that makes it one; none where it is no comment.
pub fn comment<'a>(text: &Text, line: &'a [u8]) -> Option<&'a [u8]> {
    match &text.comment {
        Some(mark) => line.strip_prefix(mark.as_bytes()),
        None => MARKS.iter().find_map(|mark| line.strip_prefix(*mark)),
    }
}

/// Cuts lines into fields, without white space around them.
#[derive(Debug)]
pub struct Splitter {
    delimiter: Delimiter,
    reader: csv_core::Reader,
    text: Vec<u8>,
    ends: Vec<usize>,
    count: usize,
}

impl Splitter {
    /// At a delimiter.
    pub fn new(delimiter: Delimiter) -> Self {
        let byte = if let Delimiter::Byte(byte) = delimiter { byte } else { b',' };
        let reader = csv_core::ReaderBuilder::new().delimiter(byte).build();
        Self { delimiter, reader, text: Vec::new(), ends: Vec::new(), count: 0 }
    }

    /// Takes the next line.
    pub fn split(&mut self, line: &[u8]) {
        self.count = 0;
        if self.text.len() < line.len() + 1 {
            self.text.resize(line.len() + 1, 0);
            self.ends.resize(line.len() + 2, 0);
        }
        match self.delimiter {
            Delimiter::Blanks => {
                let mut end = 0;
                let words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
                for word in words {
                    self.text[end..end + word.len()].copy_from_slice(word);
                    end += word.len();
                    self.ends[self.count] = end;
                    self.count += 1;
                }
            }
            Delimiter::Byte(_) => {
                self.reader.reset();
                let (mut read, mut written, mut ended) = (0, 0, 0);
                loop {
                    let (result, taken, put, fields) = self.reader.read_record(
                        &line[read..],
                        &mut self.text[written..],
                        &mut self.ends[ended..],
                    );
                    (read, written, ended) = (read + taken, written + put, ended + fields);
                    // The buffers hold the whole line, so only its end ends it.
                    if !matches!(result, ReadRecordResult::InputEmpty) {
                        break;
                    }
                }
                self.count = ended;
            }
        }
    }

    /// Number of fields of the line at hand.
    pub fn count(&self) -> usize {
        self.count
    }

    /// A field of it.
    pub fn field(&self, i: usize) -> Option<&[u8]> {
        let ends = &self.ends[..self.count];
        let end = *ends.get(i)?;
        let start = i.checked_sub(1).map_or(0, |before| ends[before]);
        Some(self.text[start..end].trim_ascii())
    }

    /// All of them.
    pub fn fields(&self) -> impl Iterator<Item = &[u8]> {
        (0..self.count).filter_map(|i| self.field(i))
    }
}

/// The number that a field is.
pub fn number(field: &[u8]) -> Option<f64> {
    std::str::from_utf8(field).ok()?.parse().ok()
}
