//! Errors of runs, their claimed size, and figures over them.

use super::drive::OUTAGE;
use schuler::aiding::aided::verdict::Verdict;

/// What was seen at a second.
#[derive(Clone, Copy)]
pub struct Read {
    pub second: f64,
    /// The drift: position, velocity, attitude.
    pub errors: [f64; 9],
    pub covariance: [[f64; 9]; 9],
}

impl Read {
    /// eᵀP⁻¹e of some components.
    pub fn nees<const K: usize>(&self, components: [usize; K]) -> f64 {
        let p = components.map(|i| components.map(|j| self.covariance[i][j]));
        let e = components.map(|i| self.errors[i]);
        quadratic(p, e)
    }
}

/// eᵀP⁻¹e by Cholesky's factors.
pub fn quadratic<const K: usize>(p: [[f64; K]; K], e: [f64; K]) -> f64 {
    let (mut l, mut z, mut sum) = ([[0.0; K]; K], [0.0; K], 0.0);
    for i in 0..K {
        for j in 0..=i {
            let rest: f64 = p[i][j] - (0..j).map(|k| l[i][k] * l[j][k]).sum::<f64>();
            l[i][j] = if i == j { rest.sqrt() } else { rest / l[j][j] };
        }
        z[i] = (e[i] - (0..i).map(|k| l[i][k] * z[k]).sum::<f64>()) / l[i][i];
        sum += z[i] * z[i];
    }
    sum
}

/// What came of a run.
pub struct Flown {
    pub reads: Vec<Read>,
    pub verdicts: Vec<Verdict<f64>>,
}

/// Figures over runs: root mean squares in 3-D position, m, velocity, m/s, tilt and heading, rad, from 120 to 400 s, and
/// of the position at the end of the outage; of the errors, then of what is claimed; mean NEES by its degrees.
#[derive(Clone, Copy, Debug, Default)]
pub struct Figures {
    pub rms: [f64; 5],
    pub claimed: [f64; 5],
    pub nees: [f64; 4],
    pub nis: f64,
    pub refused: usize,
    pub judged: usize,
}

pub fn figures(runs: &[Flown]) -> Figures {
    let mut f = Figures::default();
    let groups: [&[usize]; 4] = [&[0, 1, 2], &[3, 4, 5], &[6, 7], &[8]];
    let steady = || {
        runs.iter().flat_map(|run| run.reads.iter().filter(|r| (120.0..=400.0).contains(&r.second)))
    };
    let ends = || {
        runs.iter().flat_map(|run| run.reads.iter().filter(|r| (r.second - OUTAGE[1]).abs() < 0.5))
    };
    let mean = |reads: &mut dyn Iterator<Item = f64>| {
        let (mut sum, mut n) = (0.0, 0.0);
        for x in reads {
            sum += x;
            n += 1.0;
        }
        sum / n
    };
    let square =
        |r: &Read, group: &[usize]| group.iter().map(|i| r.errors[*i].powi(2)).sum::<f64>();
    let claim = |r: &Read, group: &[usize]| group.iter().map(|i| r.covariance[*i][*i]).sum::<f64>();
    for (n, group) in groups.iter().enumerate() {
        f.rms[n] = mean(&mut steady().map(|r| square(r, group))).sqrt();
        f.claimed[n] = mean(&mut steady().map(|r| claim(r, group))).sqrt();
    }
    f.rms[4] = mean(&mut ends().map(|r| square(r, groups[0]))).sqrt();
    f.claimed[4] = mean(&mut ends().map(|r| claim(r, groups[0]))).sqrt();
    f.nees = [
        mean(&mut steady().map(|r| r.nees([0, 1, 2]) / 3.0)),
        mean(&mut steady().map(|r| r.nees([3, 4, 5]) / 3.0)),
        mean(&mut steady().map(|r| r.nees([6, 7, 8]) / 3.0)),
        mean(&mut steady().map(|r| r.nees([0, 1, 2, 3, 4, 5, 6, 7, 8]) / 9.0)),
    ];
    let verdicts = || runs.iter().flat_map(|run| &run.verdicts);
    let degrees: u32 = verdicts().filter(|v| v.accepted).map(|v| v.kind.degrees()).sum();
    f.nis = verdicts().filter(|v| v.accepted).map(|v| v.nis).sum::<f64>() / f64::from(degrees);
    f.judged = verdicts().count();
    f.refused = verdicts().filter(|v| !v.accepted).count();
    f
}
