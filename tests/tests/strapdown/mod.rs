//! Strapdown: fit, body step, gravitation, streams, accuracy, refusals, records.

/// Calls a generic function once for every named window, the last of its type arguments.
macro_rules! for_every_window {
    ($f:ident $(, $first:ty)?) => {{
        use schuler::strapdown::block::window::*;
        schuler::strapdown::block::window::every_window!(for_every_window! @ $f [$($first)?]);
    }};
    (@ $f:ident [] $($w:ident),+) => { $($f::<$w>();)+ };
    (@ $f:ident [$first:ty] $($w:ident),+) => { $($f::<$first, $w>();)+ };
}

mod accuracy;
mod body;
mod cones;
mod coning;
mod corrected;
mod corrected_flights;
mod edges;
mod fit;
mod gravitation;
mod printed;
mod record;
mod rejects;
mod responses;
mod restored;
mod selected;
mod starts;
mod stream;
mod unequal;
