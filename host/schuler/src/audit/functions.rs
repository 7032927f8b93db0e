//! The functions of libm that the core calls: a digest of each over many arguments, kept with the golden
//! chains. It tells another libm from another core where chains part.

use schuler::digest::Digest;
use schuler::math::real::Scalar;
use schuler::noise::{Stream, Streams};
use schuler::record::Record;
use schuler_simulator::input::name::name_of;
use schuler_simulator::input::{Complaint, InputError, read_text};
use schuler_simulator::output;
use serde::Serialize;
use std::path::Path;

/// The file of a golden folder.
pub const FILE: &str = "functions.txt";
const MAGIC: &str = "schuler functions 1";
const ARGUMENTS: u32 = 100_000;
const SEED: u64 = 20_261_127;

/// A function in one precision.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Function {
    /// Precision and name: `f32 sin_cos`.
    pub name: String,
    /// The digest of its values.
    pub digest: String,
}

/// A stored function beside this build's.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Verdict {
    /// Precision and name.
    pub function: String,
    /// The stored digest.
    pub stored: String,
    /// This build's.
    pub computed: String,
}

impl Verdict {
    /// Whether both are the same.
    pub fn holds(&self) -> bool {
        self.stored == self.computed
    }
}

/// Where arguments lie: a sign, and a power of two times 1 to 2.
struct Range {
    signs: bool,
    exponents: [i64; 2],
}

/// ±2ᵃ to ±2ᵇ.
const fn both_signs(a: i64, b: i64) -> Range {
    Range { signs: true, exponents: [a, b] }
}

/// 2ᵃ to 2ᵇ.
const fn positive(a: i64, b: i64) -> Range {
    Range { signs: false, exponents: [a, b] }
}

impl Range {
    /// An argument, rounded to its type: evenly spread exponents, so that small ones come up as well.
    fn draw<R: Scalar>(&self, stream: &mut Stream) -> R {
        let [least, end] = self.exponents;
        let exponent = least + (stream.next_u64() % (end - least) as u64) as i64;
        let bits = stream.next_u64();
        let sign = if self.signs { bits & 1 << 63 } else { 0 };
        R::narrow(f64::from_bits(sign | ((1023 + exponent) as u64) << 52 | bits & ((1 << 52) - 1)))
    }
}

/// The digest of a function of two numbers with up to two values.
fn digest<R: Scalar + Record>(
    ranges: [Range; 2],
    mut function: impl FnMut(R, R) -> [R; 2],
) -> String {
    let mut stream = Streams::new(SEED, 0).open();
    let mut digest = Digest::default();
    for _ in 0..ARGUMENTS {
        let [x, y] = ranges.each_ref().map(|range| range.draw(&mut stream));
        function(x, y).iter().for_each(|value| digest.add(value));
    }
    format!("{:016x}", digest.value())
}

/// Each function over the arguments that flights and sensors have.
fn of_type<R: Scalar + Record>(precision: &str, functions: &mut Vec<Function>) {
    let mut add = |name: &str, range: [Range; 2], function: fn(R, R) -> [R; 2]| {
        functions.push(Function {
            name: format!("{precision} {name}"),
            digest: digest(range, function),
        });
    };
    let none = || positive(0, 1);
    // Angles, some turns of them; coordinates up to the Earth's radius in metres.
    add("sin_cos", [both_signs(-40, 5), none()], |x, _| x.sin_cos().into());
    add("atan2", [both_signs(-30, 23), both_signs(-30, 23)], |y, x| [y.atan2(x), R::ZERO]);
    // An interval over a correlation time; probabilities down to 2⁻⁶⁴.
    add("exp_m1", [both_signs(-40, 6), none()], |x, _| [x.exp_m1(), R::ZERO]);
    add("ln", [positive(-64, 2), none()], |x, _| [x.ln(), R::ZERO]);
    add("round", [both_signs(-3, 30), none()], |x, _| [x.round(), R::ZERO]);
    add("sqrt", [positive(-60, 60), none()], |x, _| [x.sqrt(), R::ZERO]);
}

/// The functions of this build.
pub fn computed() -> Vec<Function> {
    let mut functions = Vec::new();
    of_type::<f64>("f64", &mut functions);
    of_type::<f32>("f32", &mut functions);
    functions
}

/// Writes this build's functions into a folder.
pub fn record(folder: &Path, provenance: &str) -> Result<(), InputError> {
    let mut text = format!(
        "{MAGIC}\nprovenance: {provenance}\n\
         about: digests of libm's functions, through the core's Real, over {ARGUMENTS} arguments each \
         (host/src/audit/functions.rs)\n\n"
    );
    for Function { name, digest } in computed() {
        text += &format!("{name} {digest}\n");
    }
    output::write(folder.join(FILE), text)
}

/// Compares this build's functions with a folder's; `None` where it holds none.
pub fn verify(folder: &Path) -> Result<Option<Vec<Verdict>>, InputError> {
    let path = folder.join(FILE);
    if !path.exists() {
        return Ok(None);
    }
    let file = name_of(&path);
    let stored = parse(&file, &read_text(&file)?)?;
    let mut verdicts = Vec::new();
    for Function { name, digest } in computed() {
        let Some(stored) = stored.iter().find(|stored| stored.name == name) else {
            let complaint = Complaint::new(format!("lacks {name}"), format!("{name} DIGEST"));
            return Err(InputError::file(&file, complaint));
        };
        let stored = stored.digest.clone();
        verdicts.push(Verdict { function: name, stored, computed: digest });
    }
    Ok(Some(verdicts))
}

fn parse(file: &str, text: &str) -> Result<Vec<Function>, InputError> {
    let bad = |line: u64, what: &str, accepted: &str| {
        InputError::line(file, line, Complaint::new(what, accepted))
    };
    let mut lines = (1..).zip(text.lines().map(str::trim_end));
    if lines.next().is_none_or(|(_, line)| line != MAGIC) {
        let accepted = format!("the first line \"{MAGIC}\"");
        return Err(bad(1, "is no list of functions", &accepted));
    }
    let mut functions = Vec::new();
    for (number, line) in lines.skip_while(|(_, line)| !line.is_empty()).skip(1) {
        match line.rsplit_once(' ') {
            Some((name, digest)) if digest.len() == 16 => {
                functions.push(Function { name: name.to_owned(), digest: digest.to_owned() });
            }
            _ => return Err(bad(number, "is no function", "f32|f64 FUNCTION DIGEST")),
        }
    }
    Ok(functions)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_ulp_of_one_value_is_another_digest() {
        let sine = |planted: u32| {
            let mut calls = 0;
            digest([both_signs(-40, 5), positive(0, 1)], |x: f32, _| {
                calls += 1;
                let (sine, cosine) = schuler::math::real::Real::sin_cos(x);
                [f32::from_bits(sine.to_bits() + u32::from(calls == planted)), cosine]
            })
        };
        assert_eq!(sine(0), sine(0));
        for planted in [1, 500, ARGUMENTS] {
            assert_ne!(sine(0), sine(planted), "{planted}");
        }
    }

    #[test]
    fn arguments_fill_their_range() {
        let mut stream = Streams::new(SEED, 0).open();
        let range = both_signs(-2, 3);
        let mut drawn: Vec<f64> = (0..1000).map(|_| range.draw(&mut stream)).collect();
        drawn.sort_by(f64::total_cmp);
        assert!(drawn.iter().all(|x| (0.25..8.0).contains(&x.abs())));
        assert!(drawn[0] < -7.0 && drawn[999] > 7.0);
        assert!(drawn.iter().any(|x| x.abs() < 0.3));
    }

    #[test]
    fn what_is_no_list_is_refused() {
        assert!(parse("f", "hello").is_err());
        assert!(parse("f", &format!("{MAGIC}\n\nf64 ln 12\n")).is_err());
        let functions = parse("f", &format!("{MAGIC}\nabout: it\n\nf64 ln 0123456789abcdef\n"));
        assert_eq!(functions.unwrap()[0].name, "f64 ln");
    }
}
