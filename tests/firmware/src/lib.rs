//! What the images share: the board, the paper's scene, and measuring.

#![no_std]

pub mod application;
pub mod board;
pub mod navigation;
pub mod paper;
