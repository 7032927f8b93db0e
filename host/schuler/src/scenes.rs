//! `schuler scenes`: what there is to fly, and how to write more of it.

use crate::cli::ScenesArgs;
use schuler_simulator::input::document::did_you_mean;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::{print, say};
use schuler_simulator::scene::{builtin, keys};

/// Lists the built-in scenes, prints one, or every key.
pub fn scenes(args: &ScenesArgs) -> Result<(), InputError> {
    if args.keys {
        return print(&keys::reference());
    }
    let Some(name) = &args.name else {
        let lines = builtin::names().map(|(name, title)| format!("{name:14} {title}\n"));
        return say(&lines.collect::<String>());
    };
    match builtin::text(name) {
        Some(text) => print(text),
        None => {
            let names: Vec<_> = builtin::names().map(|(name, _)| name).collect();
            let what = format!("there is no such scene{}", did_you_mean(name, &names));
            Err(InputError::option(name, Complaint::new(what, builtin::list())))
        }
    }
}
