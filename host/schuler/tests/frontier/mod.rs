//! `schuler frontier`: the command as a user meets it, and what it measures.

mod command;
mod measure;
