//! The built program, run as its users run it.
#![cfg(test)]

/// What every test needs: a place of its own, the program, a small world and a small log.
mod workbench;

/// What `run` and `replay` leave on disk and on screen, and how they end.
mod command_line;

/// What `check` says of files, good and bad.
mod checks;

/// What `study` shows and leaves: the same whatever the number of cores.
mod studies;

/// Arguments and files that cannot be used: each ends with exit code 2, the place and the way out.
mod bad_arguments;

/// What `figures` draws, and how it ends.
mod figures;
/// Pictures of floors that become worlds.
mod floor_plans;

/// The logs of real robots, where they are at hand.
mod real_logs;
