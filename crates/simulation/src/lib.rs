//! The virtual laboratory of Cogmap: a world, a robot that sees and moves in it with the errors of
//! a real one, and the session, from which every run can be replayed to the last bit.
//!
//! [`World`] is a building as its author wrote it down; [`Solids`] is what laser and body meet of
//! it. [`Robot`] says how well a [`Body`], a [`Laser`] and an [`Odometer`] work. [`Driver`] is the
//! person at the controls, who sees the truth; the mappers never do. [`Session`] runs it all, from
//! a world or from a recorded log:
//!
//! ```
//! use cogmap_mapping::MapperSetup;
//! use cogmap_simulation::{Command, Robot, Session, SessionRecord, Source, World};
//!
//! let world: World = serde_json::from_str(r#"{
//!     "format": "cogmap-world/1", "name": "Cell",
//!     "walls": [[[0,0],[5,0],[5,4],[0,4],[0,0]]],
//!     "start": {"position": [1,2]}
//! }"#).unwrap();
//! let source = Source::world(world, Robot::named("bad").unwrap());
//! let mapper = MapperSetup::named("perceptual").unwrap();
//! let mut session = Session::drive(SessionRecord::new(source, vec![mapper], 1)).unwrap();
//!
//! session.command(Command::Step { turn: 0.3, travel: 1.0 });
//! while session.advance() && !session.at_rest() {}
//! assert_eq!(session.journal().mappers[0].reports.len(), 2);
//! ```

mod body;
mod building;
mod chance;
mod command;
mod dice;
mod driver;
mod episode;
mod event;
mod laser;
mod odometer;
mod raycast;
mod robot;
mod session;
mod solids;
mod strategy;
mod world;

pub use body::{Body, StepEnd, Tick};
pub use building::Building;
pub use command::{Command, TimedCommand};
pub use driver::{Driver, random_route, shortest_way};
pub use episode::{Episode, Setting};
pub use event::{SessionEvent, WorldEvent};
pub use laser::{Laser, SOMEBODY};
pub use odometer::{Odometer, WheelTurns};
pub use raycast::{Disc, Fan, Hit, RayGrid};
pub use robot::{BodyParams, LaserParams, OdometryErrors, Robot};
pub use session::{
    Ending, Homeward, Journal, MapperJournal, Pilot, Recording, SESSION_FORMAT, Session, SessionRecord,
    Source, Stamped, WayHome, wall_of,
};
pub use solids::{Nearest, Obstacles, Solids, Surroundings};
pub use strategy::Strategy;
pub use world::{BoxObstacle, Door, Noise, Person, Post, Problem, Room, Start, World, WorldChange};

/// Seconds of one tick: the time step of the simulation.
pub const TICK: f64 = 0.02;
