use cogmap_mapping::Event;
use cogmap_navigation::HomingEvent;
use serde::Serialize;

use crate::WorldChange;

/// Something worth a line in `events.jsonl` and a mark on the timeline, whoever it happened to.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum SessionEvent {
    /// To the map.
    Map(Event),
    /// To a robot on its way home.
    Homing(HomingEvent),
    /// To the robot or around it; the robot need not have noticed.
    World(WorldEvent),
}

/// Something that happened in the world.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum WorldEvent {
    /// The robot drove into something while it was moving.
    Collision {
        /// Where, in the world, metres.
        position: [f64; 2],
    },
    /// The user took over from a robot that was on its way home.
    Stopped,
    /// Something was changed around the robot.
    WorldChanged(WorldChange),
}
