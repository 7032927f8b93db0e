//! `schuler audit`: digests of flights, and the first difference of two flights.
//!
//! | file | what |
//! |---|---|
//! | `configuration` | the navigators that are flown |
//! | `record` | a scene's stages into chains |
//! | `chain` | the files: format, writing |
//! | `read` | the files: reading |
//! | `label` | names of words |
//! | `golden` | folders of chains, flown again |
//! | `functions` | digests of libm's functions beside them |
//! | `pair` | two chains side by side |
//! | `difference` | two values of a word |
//! | `compare` | the first difference of two chains |
//! | `heads` | heads that contradict each other |
//! | `tolerance` | how far fields may be apart |
//! | `verdict` | whether they are, in words |
//! | `heat` | that effect as a heat map |
//! | `sensitivity` | the effect of one unit in the last place |
//! | `show` | results as tables |
//! | `page` | results as HTML and JSON |

pub mod chain;
pub mod compare;
pub mod configuration;
pub mod difference;
pub mod functions;
pub mod golden;
pub mod heads;
mod heat;
mod label;
pub mod page;
pub mod pair;
mod provenance;
mod read;
pub mod record;
pub mod sensitivity;
mod show;
pub mod tolerance;
mod verdict;

use crate::cli::{AuditCommand, CompareArgs, RecordArgs, SensitivityArgs, VerifyArgs};
use chain::Chain;
use configuration::Named as _;
use page::Top;
use schuler::flight::configuration::Configuration;
use schuler_simulator::input::name::name_of;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::navigator::stepping;
use schuler_simulator::output::{self, say};
use schuler_simulator::scene::{self, builtin};
use schuler_simulator::simulate::FlightError;
use std::path::Path;

/// Does what is asked for.
pub fn audit(command: &AuditCommand) -> Result<(), FlightError> {
    match command {
        AuditCommand::Record(args) => record(args),
        AuditCommand::Verify(args) => verify(args),
        AuditCommand::Compare(args) => compare(args),
        AuditCommand::Sensitivity(args) => sensitivity(args),
    }
}

fn record(args: &RecordArgs) -> Result<(), FlightError> {
    let chosen = chosen(&args.configuration)?;
    let provenance = provenance::line();
    for name in &args.scene {
        let mut scene = scene::unaided(scene::load(name)?)?;
        args.flight.apply(&mut scene)?;
        let cadence = record::Cadence {
            checkpoint: args.checkpoint,
            rows: args.rows.unwrap_or_else(|| scene.samples()),
        };
        let chains = record::record(&scene, &chosen, cadence, &provenance)?;
        if builtin::scene(name).is_none() {
            keep_scene(name, &args.out.join(format!("{}.toml", scene.name)))?;
        }
        for (stem, chain) in &chains {
            output::write(golden::path(&args.out, &scene.name, stem), chain.text())?;
        }
        say(&show::recorded(&scene.name, &chains).text())?;
    }
    functions::record(&args.out, &provenance)?;
    say(&format!("written to {}\n", args.out.display()))?;
    Ok(())
}

/// A chain of a scene that is not built in needs the scene beside it, to be flown again.
fn keep_scene(from: &str, to: &Path) -> Result<(), InputError> {
    if Path::new(from).canonicalize().ok() == to.canonicalize().ok() && to.exists() {
        return Ok(());
    }
    output::write(to, schuler_simulator::input::read_text(from)?)
}

fn chosen(names: &[String]) -> Result<Vec<Configuration>, InputError> {
    if names.is_empty() {
        return Ok(stepping::all());
    }
    let find = |name: &String| {
        let known = |c: &&Configuration| c.stem() == *name || c.title() == *name;
        stepping::all().iter().find(known).copied().ok_or_else(|| {
            let names: Vec<_> = stepping::all().iter().map(|c| c.stem()).collect();
            let complaint = Complaint::new(format!("there is no {name}"), names.join(", "));
            InputError::option("--configuration", complaint)
        })
    };
    names.iter().map(find).collect()
}

fn verify(args: &VerifyArgs) -> Result<(), FlightError> {
    let functions = functions::verify(&args.folder)?;
    say(&show::functions(functions.as_deref()))?;
    let functions = functions.unwrap_or_default();
    let verdicts = golden::verify(&args.folder, &mut |verdict| say(&show::verdict(verdict)))?;
    let failed = verdicts.iter().filter(|verdict| verdict.parting.is_some()).count();
    say(&show::verified(&verdicts, failed))?;
    if let Some(folder) = &args.out {
        let verdict = Some(show::equal(verdicts.len(), failed));
        let top = Top { title: "Golden chains".to_owned(), verdict, ..Top::default() };
        page::write(folder, &top, &show::verdicts(&verdicts), &verdicts)?;
    }
    let failed = failed + functions.iter().filter(|function| !function.holds()).count();
    if failed > 0 {
        return Err(FlightError::Failed { failed, checks: verdicts.len() + functions.len() });
    }
    Ok(())
}

fn compare(args: &CompareArgs) -> Result<(), FlightError> {
    let (a, b) = (&args.a, &args.b);
    let pairs = if a.is_dir() && b.is_dir() {
        let (of_a, of_b) = (golden::list(a)?, golden::list(b)?);
        for (has, lacks, folder) in [(&of_a, &of_b, b), (&of_b, &of_a, a)] {
            if let Some((name, _)) = has.iter().find(|x| !lacks.iter().any(|y| x.0 == y.0)) {
                let accepted =
                    "a folder with the chains of the other, or a single chain and another";
                let complaint = Complaint::new(format!("lacks the chain {name}"), accepted);
                return Err(InputError::file(&folder.display().to_string(), complaint).into());
            }
        }
        let both = of_a.into_iter().zip(of_b);
        both.map(|((name, a), (_, b))| (name, a, b)).collect()
    } else if let Some(folder) = [a, b].into_iter().find(|path| path.is_dir()) {
        let complaint =
            Complaint::new("is a folder, unlike the other", "two chains, or two folders");
        return Err(InputError::file(&folder.display().to_string(), complaint).into());
    } else {
        let name = a.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        vec![(name, a.clone(), b.clone())]
    };
    let rules: Vec<_> = args.ulps.iter().chain(&args.within).cloned().collect();
    let mut found = Vec::new();
    for (name, a, b) in &pairs {
        let (a, b) = (name_of(a), name_of(b));
        let (one, other) = (Chain::read(&a)?, Chain::read(&b)?);
        let heads = heads::contradictions(&one, &other);
        say(&show::heads(&heads))?;
        let (held, parting) = compare::compare(&one, &other, &b)?;
        let fields = (!rules.is_empty())
            .then(|| tolerance::judge(&pair::pairs(&one, &other, &b)?.0, &rules, &b));
        let compared = show::Compared {
            chain: name.clone(),
            heads,
            held,
            parting,
            fields: fields.transpose()?,
        };
        say(&show::compared(&compared, one.get("rate_hz")))?;
        found.push(compared);
    }
    let parted = found.iter().filter(|compared| compared.fails()).count();
    if found.len() > 1 {
        say(&show::first(&found))?;
    }
    if let Some(folder) = &args.out {
        let verdict = Some(show::equal(found.len(), parted));
        let top = Top { title: "Where chains part".to_owned(), verdict, ..Top::default() };
        page::write(folder, &top, &show::partings(&found), &found)?;
    }
    if parted > 0 {
        return Err(FlightError::Failed { failed: parted, checks: found.len() });
    }
    Ok(())
}

fn sensitivity(args: &SensitivityArgs) -> Result<(), FlightError> {
    let scene = args.scene()?;
    let end_s = scene.samples() as f64 / scene.rate_hz;
    let mut times_s = args.after.clone();
    if times_s.is_empty() {
        times_s.extend([1.0, 10.0, 100.0, 1000.0].into_iter().filter(|&t| t < end_s));
        times_s.push(end_s);
    }
    if let Some(late) = times_s.iter().find(|&&t| t > end_s || t * scene.rate_hz < 1.0) {
        let accepted = format!("seconds, from {} to {end_s}", 1.0 / scene.rate_hz);
        let what = format!("the flight has no sample at {late} s");
        return Err(InputError::option("--after", Complaint::new(what, accepted)).into());
    }
    let effects = sensitivity::sensitivity(&scene, &times_s)?;
    let tables = show::sensitivity(&scene, &effects);
    say(&tables.iter().map(page::Table::text).collect::<String>())?;
    if let Some(folder) = &args.out {
        let title = format!("One unit in the last place: {}", scene.name);
        let top = Top { title, figure: heat::map(&effects), verdict: None };
        page::write(folder, &top, &tables, &effects)?;
    }
    Ok(())
}
