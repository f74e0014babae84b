use cogmap_simulation::WorldChange;
use serde::Serialize;
use tsify::Tsify;

use crate::{homing::HomingStatus, views::View};

/// What a run looks like at this moment.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct Status {
    /// Where the readings come from.
    pub source: SourceKind,
    /// Whether it came from a file that somebody brought.
    pub foreign: bool,
    /// Whether the file itself says with what it runs, as a session does.
    pub settled: bool,
    /// The name of the world or of the log.
    pub name: String,
    /// What files saved from this run are called, without extension.
    pub stem: String,
    /// The robot; a log does not name its own.
    pub robot: Option<String>,
    /// Everything random came from it.
    pub seed: u64,
    /// Ticks or readings so far.
    pub position: u64,
    /// The furthest position known.
    pub end: u64,
    /// Seconds since the beginning.
    pub time: f64,
    /// Whether nothing will happen until an order comes.
    pub idle: bool,
    /// Whether a route is being played.
    pub on_route: bool,
    /// Metres that are left of a way that somebody drew, while the robot follows one.
    pub way_left: Option<f64>,
    /// How often the robot drove into something.
    pub collisions: usize,
    /// Metres driven, as the odometry tells it.
    pub travelled: f64,
    /// Where the robot truly is and where it faces, metres and radians; a log does not say.
    pub pose: Option<[f64; 3]>,
    /// What can be changed around the robot; a log has no building.
    pub building: Option<BuildingStatus>,
    /// What each mapper has in mind.
    pub memories: Vec<MemoryStatus>,
    /// How it goes with going home; nothing where that is not what the robot does or did last.
    pub homing: Option<HomingStatus>,
    /// The mapper that led the robot home earlier in this run, before the way home that it is on or made last: a
    /// run has one for all its ways home.
    pub led: Option<String>,
    /// How many things that a person did can be undone.
    pub undoable: usize,
    /// How many that were undone can be done again.
    pub redoable: usize,
    /// How many other futures were left when the run went on otherwise from an earlier moment.
    pub branches: usize,
}

/// What of a building can be changed, as it is now.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct BuildingStatus {
    /// Its doors.
    pub doors: Vec<DoorStatus>,
    /// How many cartons and pieces of furniture stand in it.
    pub boxes: usize,
    /// The names of its rooms.
    pub rooms: Vec<String>,
    /// How many people walk in it.
    pub people: usize,
    /// How large the robot's odometry errors are, in multiples of its own …
    pub odometry_noise: f64,
    /// … and its laser's.
    pub laser_noise: f64,
}

/// A door as it is now.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Tsify)]
pub struct DoorStatus {
    /// What it is called.
    pub name: String,
    /// Whether it stands open.
    pub open: bool,
}

/// What one mapper has in mind at this moment.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct MemoryStatus {
    /// The view that shows it.
    pub view: View,
    /// The mapper.
    pub mapper: String,
    /// How many surfaces it remembers.
    pub surfaces: usize,
    /// How many views they were taken from.
    pub views: usize,
    /// How many local spaces it knows; nothing where it does not know what a space is.
    pub asrs: Option<usize>,
    /// How many exits.
    pub exits: Option<usize>,
    /// How far off the robot is, where the truth is known.
    pub off: Option<Offset>,
    /// What it made of the latest view.
    pub last: Option<LastView>,
    /// What happened lately that is worth a word.
    pub happened: Option<Happened>,
}

/// Something that happened in a mapper's mind.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct Happened {
    /// The number of the view with which it happened.
    pub step: usize,
    /// How long ago that was, seconds of the run.
    pub ago: f64,
    /// What.
    pub what: Happening,
}

/// What can happen in a mapper's mind that is worth a word; the numbers are those of the files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Tsify)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Happening {
    /// The robot went through an exit.
    Exit {
        /// Which.
        exit: u32,
        /// The local space that it is in since.
        asr: u32,
    },
    /// A local space was opened behind an exit.
    NewAsr {
        /// Which.
        asr: u32,
        /// The exit.
        exit: u32,
    },
    /// The robot is back in a local space that it knew.
    LoopClosed {
        /// Which.
        asr: u32,
        /// The exit that now leads there.
        exit: u32,
    },
    /// Nothing in view was known; only odometry said where the robot was.
    Unseen,
    /// The robot is not where it believed to be, and begins a map of its own.
    Lost,
    /// The robot found itself in a place that it knew, and goes on in its coordinates.
    Recognised,
    /// The robot was told to go home.
    ToldHome,
    /// The robot was set down elsewhere.
    Kidnapped,
    /// Something was changed around the robot.
    WorldChanged {
        /// What.
        change: Changed,
    },
}

/// What can be changed around a robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum Changed {
    /// A door was opened.
    DoorOpened,
    /// A door was shut.
    DoorShut,
    /// A box was set down.
    BoxDropped,
    /// A box was moved.
    BoxMoved,
    /// A box was taken away.
    BoxRemoved,
    /// Somebody came.
    SomebodyCame,
    /// The robot's errors were made larger or smaller.
    NoiseChanged,
}

impl From<&WorldChange> for Changed {
    fn from(change: &WorldChange) -> Self {
        match change {
            WorldChange::Door { open: true, .. } => Self::DoorOpened,
            WorldChange::Door { open: false, .. } => Self::DoorShut,
            WorldChange::AddBox { .. } => Self::BoxDropped,
            WorldChange::MoveBox { .. } => Self::BoxMoved,
            WorldChange::RemoveBox { .. } => Self::BoxRemoved,
            WorldChange::AddPerson(_) => Self::SomebodyCame,
            WorldChange::Noise(_) => Self::NoiseChanged,
        }
    }
}

/// What a run's readings come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum SourceKind {
    /// A robot driven through a building.
    World,
    /// A recorded log.
    Log,
}

/// The difference between where a robot is and where it believes it is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct Offset {
    /// Metres.
    pub distance: f64,
    /// Degrees, never negative.
    pub heading_deg: f64,
}

/// What a mapper made of one view.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct LastView {
    /// Its number.
    pub step: usize,
    /// How many surfaces were seen.
    pub seen: usize,
    /// How many of them were recognised.
    pub recognised: usize,
    /// How many were new and are now in the map.
    pub placed: usize,
    /// What placed them.
    pub placement: PlacementKind,
    /// The reference pair: which surface of the view is which surface of the map.
    pub reference: Option<ReferencePair>,
}

/// What a view was placed by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum PlacementKind {
    /// The first view defines the map's frame.
    First,
    /// A reference target.
    Reference,
    /// A reference whose place along its own line was a guess.
    WeakReference,
    /// All recognised surfaces together.
    Consensus,
    /// The same, and odometry along a direction that they leave open.
    PartlyOdometry,
    /// The measured movement, corrected until the views fitted.
    Transform,
    /// Odometry.
    Odometry,
}

/// A surface that was seen and the one that it was recognised as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Tsify)]
pub struct ReferencePair {
    /// Its number in the view.
    pub seen: usize,
    /// Its number in the map.
    pub known: u32,
}
