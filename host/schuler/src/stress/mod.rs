//! `schuler stress`: the table of numerical stability, each row with the bound it must keep.
//!
//! | file | what |
//! |---|---|
//! | `case` | cases and their checks |
//! | `floor` | the bounds that follow from the arithmetic and from the Earth |
//! | `flown` | a scene flown as `schuler run` flies it |
//! | `time` | long runs, the free vertical, step sizes |
//! | `link` | jitter and loss |
//! | `motion` | fast rotation, large acceleration, tumbling, coning, sculling |
//! | `residual` | the error of a window on a cone, from its interpolation |
//! | `place` | poles, antimeridian, equator, heights |
//! | `numbers` | zeros, subnormals, no rotation |
//! | `refused` | input that cannot be right |
//! | `rounding` | how many digits are trustworthy |
//! | `aged` | states stored late, sums of many terms |
//! | `unresolved` | motion that the sampling does not resolve, noise, coarse steps |
//! | `lines`, `page` | the table in the terminal, and as a page |
//! | `fuzz` | random scenes: the plan against every window |

mod aged;
pub mod case;
pub mod floor;
mod flown;
pub mod fuzz;
mod lines;
mod link;
mod motion;
mod numbers;
pub mod page;
mod place;
mod refused;
pub mod residual;
mod rounding;
mod time;
mod unresolved;

use crate::cli::StressArgs;
use case::{Case, Check};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::number::exact;
use schuler_simulator::output::{self, OutputFile, say};
use schuler_simulator::progress::CaseProgress;
use schuler_simulator::simulate::FlightError;

/// Every case, the long ones among them.
pub fn cases() -> Vec<Case> {
    let groups = [
        time::cases,
        link::cases,
        motion::cases,
        unresolved::cases,
        place::cases,
        numbers::cases,
        refused::cases,
        rounding::cases,
        aged::cases,
        fuzz::cases,
    ];
    groups.into_iter().flat_map(|cases| cases()).collect()
}

/// Runs the cases that are asked for, prints the table and writes it where that is asked for.
pub fn stress(args: &StressArgs) -> Result<(), FlightError> {
    let mut cases = cases();
    cases.retain(|case| args.full || !case.long);
    if let Some(part) = &args.case {
        let names: Vec<_> = cases.iter().map(Case::full_name).collect();
        cases.retain(|case| case.full_name().contains(part.as_str()));
        if cases.is_empty() {
            let hint = if args.full { "" } else { " without --full" };
            let what = format!("there is no case with {part} in its name{hint}");
            let accepted = format!("part of one of: {}", names.join("; "));
            return Err(InputError::option("--case", Complaint::new(what, accepted)).into());
        }
    }
    // What cannot be written is found before the long work, not after it.
    let files = args.out.as_ref().map(|folder| {
        let [table, page] = ["stress.csv", page::NAME].map(|name| folder.join(name));
        Ok::<_, InputError>([OutputFile::create(table)?, OutputFile::create(page)?])
    });
    let files = files.transpose()?;
    let rows = run(&cases)?;
    if let (Some([mut table, mut page]), Some(folder)) = (files, &args.out) {
        table.put(csv(&rows))?;
        page.put(page::page(&rows))?;
        output::place(vec![table, page], &[])?;
        say(&format!("written to {}\n", folder.display()))?;
    }
    let failed = rows.iter().filter(|row| !row.passes()).count();
    say(&format!("{} checks, {failed} failed\n", rows.len()))?;
    judge(&rows)
}

/// An error if any row fails.
pub fn judge(rows: &[Row]) -> Result<(), FlightError> {
    match rows.iter().filter(|row| !row.passes()).count() {
        0 => Ok(()),
        failed => Err(FlightError::Failed { failed, checks: rows.len() }),
    }
}

/// A check with the case that it belongs to.
#[derive(Clone, Debug)]
pub struct Row {
    group: &'static str,
    case: String,
    /// The check, or why its case broke off.
    check: Result<Check, String>,
}

impl Row {
    /// Whether the bound is kept.
    pub fn passes(&self) -> bool {
        self.check.as_ref().is_ok_and(Check::passes)
    }

    fn verdict(&self) -> &'static str {
        if self.passes() { "pass" } else { "fail" }
    }

    fn name(&self) -> String {
        match &self.check {
            Ok(check) => format!("{}, {}", self.case, check.what),
            Err(_) => self.case.clone(),
        }
    }
}

/// Runs cases and prints a row for each check as soon as it is known.
pub fn run(cases: &[Case]) -> Result<Vec<Row>, InputError> {
    let progress = CaseProgress::new(cases.len() as u64);
    let mut rows = Vec::new();
    say(&lines::head())?;
    let mut group = "";
    for case in cases {
        progress.begin(&case.full_name());
        let outcome = case.run(&progress);
        let row = |check| Row { group: case.group, case: case.name.clone(), check };
        let new: Vec<_> = match outcome {
            Ok(checks) => checks.into_iter().map(|check| row(Ok(check))).collect(),
            Err(why) => vec![row(Err(why))],
        };
        let heading = if case.group == group { String::new() } else { format!("{}\n", case.group) };
        group = case.group;
        let text = heading + &new.iter().map(lines::line).collect::<String>();
        progress.end(|| say(&text))?;
        rows.extend(new);
    }
    progress.finish();
    Ok(rows)
}

/// All rows as a CSV file. `why` is where a bound comes from, or why a case broke off.
pub fn csv(rows: &[Row]) -> Vec<u8> {
    let columns = ["group", "case", "bound", "measured", "unit", "verdict", "why"];
    let row = |row: &Row| {
        let (bound, measured, unit, why) = match &row.check {
            Ok(Check { bound, measured, unit, why, .. }) => {
                (exact(bound.value()), exact(*measured), *unit, *why)
            }
            Err(why) => (String::new(), String::new(), "", why.as_str()),
        };
        let [group, unit, verdict, why] = [row.group, unit, row.verdict(), why].map(str::to_owned);
        [group, row.name(), bound, measured, unit, verdict, why]
    };
    output::csv(columns, rows.iter().map(row))
}
