//! The table of costs.
