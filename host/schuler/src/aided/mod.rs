//! What is printed of aided navigation.

use schuler_simulator::aided::navigator::Found;
use schuler_simulator::aided::report::{Compared, Count, Report};
use schuler_simulator::number::{counted, rounded};

/// Times that are named, at most.
const NAMED: usize = 12;

/// What became of the measurements, a line for each sensor.
pub fn lines(report: &Report) -> String {
    let mut text: String = report.sensors.iter().map(line).collect();
    let odd = [
        (report.again, "came again"),
        (report.late, "came too late"),
        (report.dropped, "found no room"),
    ];
    for (count, what) in odd.into_iter().filter(|(count, _)| *count > 0) {
        text += &format!("{} {what}\n", counted(count, "measurement", "measurements"));
    }
    let times = |times: &[f64]| {
        let named: Vec<_> = times.iter().take(NAMED).map(|t| rounded(*t, 6)).collect();
        let more = match times.len().saturating_sub(NAMED) {
            0 => String::new(),
            more => format!(" and {more} times more"),
        };
        named.join(", ") + " s" + &more
    };
    text += &report.smoothed.as_ref().map(smoothed).unwrap_or_default();
    if !report.lockouts_s.is_empty() {
        text += &format!("locked out at {}\n", times(&report.lockouts_s));
    }
    if !report.restarts_s.is_empty() {
        text += &format!("the heading was looked for again at {}\n", times(&report.restarts_s));
    }
    text
}

/// What a filter has found beside the motion, a line each.
pub fn found(found: &[Found]) -> String {
    let line = |Found { name, numbers }: &Found| {
        let [numbers, sigmas] = [0, 1]
            .map(|i| numbers.iter().map(|one| rounded(one[i], 3)).collect::<Vec<_>>().join(", "));
        format!("found: {name}: {numbers} (1σ {sigmas})\n")
    };
    found.iter().map(line).collect()
}

fn smoothed(compared: &Compared) -> String {
    let Compared { span_s: [from_s, to_s], states, position_m, sigma_m, nees, .. } = compared;
    format!(
        "smoothed, {states} states from {} to {} s: position {} m off (rms), filtered {}; 1σ {}, at most {}; NEES {} of 1\n",
        rounded(*from_s, 4),
        rounded(*to_s, 4),
        rounded(position_m[0], 3),
        rounded(position_m[1], 3),
        rounded(sigma_m[0], 3),
        rounded(sigma_m[1], 3),
        rounded(*nees, 3)
    )
}

fn line(count: &Count) -> String {
    let fits = count.consistency().map_or(String::new(), |(nis, [least, most])| {
        let verdict = if nis < least {
            ": they fit better than they say"
        } else if nis > most {
            ": they fit worse than they say"
        } else {
            ""
        };
        format!(
            ", NIS {} of 1 ({} to {} in 95 %){verdict}",
            rounded(nis, 3),
            rounded(least, 3),
            rounded(most, 3)
        )
    });
    let lockouts = match count.lockouts {
        0 => String::new(),
        1 => ", locked out once".to_owned(),
        times => format!(", locked out {times} times"),
    };
    format!(
        "{}: {} taken, {} refused{lockouts}{fits}\n",
        count.sensor, count.accepted, count.refused
    )
}
