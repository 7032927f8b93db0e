//! Errors on the link to a target, as a table.

use schuler_simulator::flight::{FaultCount, LinkReport, TraceCount};

/// Faults that were put in, by kind: name, to the target, to the host.
pub fn faults(link: &LinkReport) -> Vec<Vec<String>> {
    let row = |count: &FaultCount| {
        vec![count.fault.to_owned(), count.to_target.to_string(), count.to_host.to_string()]
    };
    link.faults.iter().map(row).collect()
}

/// The headings of [`traces`].
pub const TRACES: [&str; 6] =
    ["noticed", "put in, out", "put in, back", "by the target", "by the host", ""];

/// What was noticed, beside what was put in: agreed, or not.
pub fn traces(link: &LinkReport) -> Vec<Vec<String>> {
    let row = |count: &TraceCount| {
        let by_target = count.noticed_by_target.map_or("–".to_owned(), |n| n.to_string());
        // Without faults on purpose, what is noticed is the line's own.
        let verdict = match (link.faults.is_empty(), count.is_explained()) {
            (true, _) => "",
            (false, true) => "=",
            (false, false) => "≠",
        };
        vec![
            count.trace.to_owned(),
            count.injected_to_target.to_string(),
            count.injected_to_host.to_string(),
            by_target,
            count.noticed_by_host.to_string(),
            verdict.to_owned(),
        ]
    };
    link.traces.iter().map(row).collect()
}

/// The rest, in one sentence.
pub fn sentence(link: &LinkReport) -> String {
    format!(
        "{}: {} frames out, {} back; {} broken at the target, {} at the host; {} not understood; {} sent again, {} recovered, \
         {} samples lost, {} bridged; at worst {} round trips to an answer.",
        link.device,
        link.frames_sent,
        link.frames_received,
        link.broken_at_target,
        link.broken_at_host,
        link.not_understood,
        link.resent,
        link.recovered,
        link.lost,
        link.bridged,
        link.worst_round_trips
    )
}

/// All of it for a terminal.
pub fn text(link: &LinkReport) -> String {
    let mut text = format!("\n{}\n", sentence(link));
    if !link.faults.is_empty() {
        let faults =
            faults(link).into_iter().map(|row| format!("{} {}+{}", row[0], row[1], row[2]));
        let faults: Vec<_> = faults.collect();
        text += &format!("Faults put in, out + back: {}.\n", faults.join(", "));
    }
    let heads = TRACES.map(str::to_owned).to_vec();
    for row in std::iter::once(heads).chain(traces(link)) {
        let cells = row.iter().enumerate().map(|(column, cell)| match column {
            0 => format!("{cell:<22}"),
            5 => format!(" {cell}"),
            _ => format!("{cell:>14}"),
        });
        text += &format!("{}\n", cells.collect::<String>().trim_end());
    }
    text
}
