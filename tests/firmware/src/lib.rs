//! What the images share: the board, the paper's scene, its faults, and measuring.

#![no_std]

pub mod application;
pub mod board;
pub mod fault;
pub mod measuring;
pub mod navigation;
pub mod paper;
pub mod single;
