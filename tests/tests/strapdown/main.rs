//! Strapdown: fit, body step, gravitation, streams, accuracy, refusals, records.

/// Calls a generic function once for every named window, first or last of its type arguments.
macro_rules! every_window {
    ($f:ident $(, $first:ty)?) => {{
        use schuler::strapdown::window::*;
        every_window!(
            @ $f [$($first)?] H0B2A0, H0B3A0, H0B4A0, H0B6A0, H2B2A0, H2B2A2, H2B4A0, H4B4A0, H2B4A2,
            H4B4A4, Line8, Parabola12, Parabola20, Parabola40
        );
    }};
    (@ $f:ident [] $($w:ident),+) => { $($f::<$w>();)+ };
    (@ $f:ident [$first:ty] $($w:ident),+) => { $($f::<$first, $w>();)+ };
}

mod accuracy;
mod body;
mod coning;
mod fit;
mod gravitation;
mod record;
mod rejects;
mod starts;
mod stream;
