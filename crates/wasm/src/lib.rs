//! Cogmap for the browser: one class, [`Laboratory`], over a session.
//!
//! The page holds a `Laboratory` in a worker, lets it [advance](Laboratory::advance) frame by frame,
//! gives it [orders](Laboratory::order) and lets it [paint](Laboratory::paint) the views on its
//! canvases. It never learns how a map is made: what it shows in words comes as one plain object,
//! [`Status`]. The TypeScript types of all objects are generated from the ones here; every error
//! reaches the page as an `Error` whose message is meant for people.
//!
//! Nothing here reads a clock or throws dice, so a session saved on the page replays to the same
//! bytes anywhere.

mod alteration;
mod canvas;
mod captions;
mod clause;
mod contents;
mod courses;
mod draft;
mod explaining;
mod explanation;
mod failure;
mod homing;
mod keeping;
mod laboratory;
mod landmarks;
mod layers;
mod look;
mod memories;
mod opening;
mod order;
mod plans;
mod plots;
mod remembered;
mod resumption;
mod run;
mod scenes;
mod schematic;
mod setup;
mod stance;
mod status;
mod story;
mod tracked;
#[cfg(test)]
mod two_rooms;
mod views;
mod ways;

pub use alteration::{Alteration, Objection, Tool};
pub use clause::Clause;
pub use contents::{Bearing, Contents, NearSurface, Place, SupposedExit, WayOut, Whereabouts};
pub use draft::{Checked, Draft, Fault, Thing};
pub use explanation::{
    AlongKind, Candidate, Corrected, Explanation, FittingPair, ReferenceReport, StageKind, StageReport,
    Weighed,
};
pub use homing::{Ending, HomingStatus, Lead};
pub use laboratory::Laboratory;
pub use landmarks::Landmark;
pub use layers::{Colours, Fit, Layers};
pub use look::Look;
pub use order::Order;
pub use plans::{FloorPlan, PlanReport};
pub use plots::{Curve, Narrow, OffCurve, Plots, WidenessCurve};
pub use remembered::{Remembered, RememberedKind, Walk};
pub use resumption::{Kept, KnownBuilding};
pub use schematic::{Neighbour, Schematic, SchematicExit, SchematicPlace};
pub use setup::{Choices, Opening, Setup};
pub use status::{
    BuildingStatus, Changed, DoorStatus, Happened, Happening, LastView, MemoryStatus, Offset, PlacementKind,
    ReferencePair, SourceKind, Status,
};
pub use story::{AsrFacts, ExitFacts, Facts, Occasion, SupposedFacts, SurfaceFacts, Told};
pub use views::View;
pub use ways::Followed;
