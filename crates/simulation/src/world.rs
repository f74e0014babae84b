use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

mod change;
mod check;
mod numbers;
mod reach;
mod remarks;

pub(crate) use change::{COORDINATE_MAX, ChangingWorld, New};
pub use change::{Noise, WorldChange};
pub use check::Problem;

/// A building as its author wrote it down: the content of a `NAME.world.json` file. Metres, and
/// degrees counter-clockwise. Routes and rooms are for people and for scoring; no robot sees them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct World {
    /// The JSON Schema that the file follows, for editors.
    #[serde(rename = "$schema", default, skip_serializing_if = "Option::is_none")]
    pub schema: Option<String>,
    /// Always `cogmap-world/1`.
    pub format: String,
    /// Shown to people.
    pub name: String,
    /// One or two sentences for people.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub description: String,
    /// Walls as polylines.
    #[serde(default)]
    pub walls: Vec<Vec<[f64; 2]>>,
    /// Furniture and cartons.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub boxes: Vec<BoxObstacle>,
    /// Chair and table legs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub posts: Vec<Post>,
    /// Doors that can be opened and closed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub doors: Vec<Door>,
    /// People walking to and fro.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub people: Vec<Person>,
    /// Where the robot begins.
    pub start: Start,
    /// Ways through the building, each a list of points that begins after the start.
    #[serde(default, skip_serializing_if = "std::collections::BTreeMap::is_empty")]
    pub routes: std::collections::BTreeMap<String, Vec<[f64; 2]>>,
    /// The rooms as people see them: ground truth for scoring, and labels.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rooms: Vec<Room>,
}

/// A rectangle that stands on the floor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoxObstacle {
    /// Its middle, metres.
    pub center: [f64; 2],
    /// Length and width, metres.
    pub size: [f64; 2],
    /// Direction of its length, degrees.
    #[serde(default)]
    pub heading_deg: f64,
}

/// A round leg.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Post {
    /// Its middle, metres.
    pub center: [f64; 2],
    /// Metres.
    pub radius: f64,
}

/// A door leaf, 4 cm thick. Closed, it reaches from the hinge to the latch; open, it stands at a right
/// angle, counter-clockwise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Door {
    /// How commands call it.
    pub name: String,
    /// The end that stays where it is, metres.
    pub hinge: [f64; 2],
    /// The other end when closed, metres.
    pub latch: [f64; 2],
    /// Whether it starts open.
    #[serde(default)]
    pub open: bool,
}

/// Somebody who walks along a path and back again, and stops for a standing robot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Person {
    /// The path, metres.
    pub path: Vec<[f64; 2]>,
    /// Metres per second.
    pub speed: f64,
    /// Metres.
    pub radius: f64,
}

/// Where the robot begins.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Start {
    /// Metres.
    pub position: [f64; 2],
    /// Degrees.
    #[serde(default)]
    pub heading_deg: f64,
}

/// A room as people see it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Room {
    /// Shown on screen.
    pub name: String,
    /// Its corners in order, metres.
    pub outline: Vec<[f64; 2]>,
}
