//! What the mappers promise and what they cannot, held against worlds that are known exactly.
#![allow(
    clippy::unwrap_used,
    reason = "clippy lets tests unwrap only inside test functions; here every line is a test"
)]

/// Views without beams: the exact visible parts of walls.
mod ideal;
/// Scans with beams, and with noise where it is asked for.
mod sampled;
/// Walks through a hall, seen ideally.
mod walk;

/// Looking at the map from another origin changes nothing in it (§2.2.2).
mod anchoring;
/// The corridor that is longer than the laser sees (§3.2.3).
mod corridor;
/// Odometry that has to place views does harm, the more the oftener (§3.2.3).
mod fallbacks;
/// The flaws that the thesis saw in its maps (§3.2.3), each on a case that shows it.
mod flaws;
/// What a camera would add: surfaces that can be told apart (chapter 4).
mod identity;
/// A memory that reaches no farther than the last few spaces (§2.2.2).
mod limited;
/// The forms of the literal mapper: match scope, update policy, reference rule.
mod options;
/// What the theory promises of the map (§2.3, §3.2.1): odometry never reaches it, nothing stored changes.
mod stable_world;
/// The traditional mapper (§3.1.3) does what it says.
mod traditional;
