//! What a window leaves of pure coning and sculling, to second order in the amplitude, from its
//! interpolation alone: no code of the navigator's has a part in it.
//!
//! A window passes on the integral over every sample exactly, so the first order is exact, too. To second
//! order a rotation e^{iβt} (one sample is 1 in t) drifts by ½Im∫F*F′ about the third axis, and a window
//! replaces F by the polynomial P through its values at the samples' edges.

/// Nodes and weights of Gauss-Legendre quadrature on [−1, 1], twelve points: exact up to degree 23,
/// which is P*P′ of the widest window.
const NODES: [(f64, f64); 6] = [
    (0.1252334085114689, 0.2491470458134028),
    (0.3678314989981802, 0.2334925365383548),
    (0.5873179542866175, 0.2031674267230659),
    (0.7699026741943047, 0.1600783285433462),
    (0.9041172563704749, 0.1069393259953184),
    (0.9815606342467193, 0.0471753363865118),
];

/// |∫(P − P(0))*P′ − ∫(F − F(0))*F′| over a block of the window (history, block, look-ahead), F = e^{iβt}.
pub fn product((history, block, lookahead): (usize, usize, usize), beta: f64) -> f64 {
    let edges: Vec<f64> =
        (0..=history + block + lookahead).map(|j| j as f64 - history as f64).collect();
    let (length, half) = (block as f64, block as f64 / 2.0);
    let (mut re, mut im) = (0.0, 0.0);
    for (node, weight) in NODES {
        for t in [half * (1.0 - node), half * (1.0 + node)] {
            let (mut p, mut slope) = ([-1.0, 0.0], [0.0, 0.0]);
            for (m, &edge) in edges.iter().enumerate() {
                let (value, derivative) = lagrange(&edges, m, t);
                let (sine, cosine) = (beta * edge).sin_cos();
                p = [p[0] + value * cosine, p[1] + value * sine];
                slope = [slope[0] + derivative * cosine, slope[1] + derivative * sine];
            }
            re += weight * half * (p[0] * slope[0] + p[1] * slope[1]);
            im += weight * half * (p[0] * slope[1] - p[1] * slope[0]);
        }
    }
    // ∫(F − 1)*F′ = iβB − (e^{iβB} − 1)
    let (sine, cosine) = (beta * length).sin_cos();
    (re - (1.0 - cosine)).hypot(im - (beta * length - sine))
}

/// ℓ_m(t) and ℓ_m′(t) over some edges.
fn lagrange(edges: &[f64], m: usize, t: f64) -> (f64, f64) {
    let (mut value, mut derivative) = (1.0, 0.0);
    for (i, &edge) in edges.iter().enumerate() {
        if i != m {
            let gap = edges[m] - edge;
            derivative = (derivative * (t - edge) + value) / gap;
            value *= (t - edge) / gap;
        }
    }
    (value, derivative)
}

/// Drift of pure coning per sample, rad per squared rad of the half-cone angle.
pub fn coning(window: (usize, usize, usize), beta: f64) -> f64 {
    // a²·½Im∫F*F′; the real part is ½|F|² at the ends, which any interpolation passes on
    0.5 * product(window, beta) / window.1 as f64
}

/// Largest mean velocity error of sculling per sample, for an angle of 1 rad in phase with a velocity
/// of 1 m/s in its acceleration's quadrature: ω = aβcos, f = v β cos.
pub fn sculling(window: (usize, usize, usize), beta: f64) -> f64 {
    // Re x·Re y = ½Re(x*y) + ½Re(xy), of which the second averages out over the phases
    0.5 * product(window, beta) / window.1 as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Leading terms 8β⁷/189, .00142β⁹ and .00119β¹¹ per block, and the drift per sample at ten samples
    /// per cycle from arithmetic of high precision.
    #[test]
    fn windows_leave_what_their_leading_terms_say() {
        let near = |a: f64, b: f64, part: f64| assert!((a / b - 1.0).abs() < part, "{a:e} {b:e}");
        let beta = TAU / 40.0;
        near(4.0 * coning((0, 4, 0), beta), 8.0 * beta.powi(7) / 189.0, 0.05);
        near(2.0 * coning((2, 2, 2), beta), 0.00142 * beta.powi(9), 0.05);
        let beta = TAU / 24.0;
        near(4.0 * coning((2, 4, 2), beta), 0.00119 * beta.powi(11), 0.1);
        for (window, expected) in
            [((0, 4, 0), 3.4e-4), ((2, 2, 2), 9.8e-6), ((2, 4, 2), 1.4e-6), ((4, 4, 4), 8.5e-9)]
        {
            near(coning(window, TAU / 10.0), expected, 0.04);
        }
    }
}
