use cogmap_geometry::DVec2;
use cogmap_mapping::{Sentence, memory::FrameId};
use serde::{Deserialize, Serialize};

/// What the robot is to do next.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "act", rename_all = "snake_case")]
pub enum Act {
    /// Turn by so many radians, counter-clockwise positive, then travel so many metres straight on.
    /// Where both would be needed the turn comes alone: the robot looks before it moves on.
    Step {
        /// Radians.
        turn: f64,
        /// Metres.
        travel: f64,
    },
    /// Stop: home is here, as far as the robot can tell.
    Arrived,
    /// Stop and wait for the user: nothing that the robot can think of works.
    Stuck,
}

/// What led the robot when it decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Mode {
    /// The sense of direction (§3.3.2).
    Direction,
    /// The remembered route (§3.3.4).
    Route,
    /// A way planned through remembered and assumed free space; ours.
    Planning,
}

/// A way on that is free as far as the robot can tell, and what speaks for it (§3.3.2).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct MovementOption {
    /// The end of the part that is seen, in [`Decision::frame`], metres.
    pub end: DVec2,
    /// Metres that going there and straight on to the target would be longer than the straight line.
    pub detour: f64,
    /// What the choice went by; lower is better.
    pub score: f64,
    /// Why it is not for choice although it is free: it leads into a known dead end, say.
    pub barred: bool,
}

/// What the robot decided at rest, and why.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Decision {
    /// The view that it was made after.
    pub step: usize,
    /// What to do.
    pub act: Act,
    /// What led the robot.
    pub mode: Mode,
    /// The place whose coordinates everything below is in.
    pub frame: FrameId,
    /// Where home is believed to be, metres.
    pub home: Option<DVec2>,
    /// The movement options, in counter-clockwise order.
    pub options: Vec<MovementOption>,
    /// Which of them was taken.
    pub chosen: Option<usize>,
    /// The way that the robot has in mind, from where it stands, metres: what it sees first, what it assumes behind.
    pub way: Vec<DVec2>,
    /// The waypoints of the remembered route that are still ahead, metres.
    pub waypoints: Vec<DVec2>,
    /// One sentence for people.
    pub why: Sentence,
    /// What is worth a line in the log.
    pub events: Vec<HomingEvent>,
}

/// Something on the way home that is worth a line in `events.jsonl` and a mark on the timeline.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum HomingEvent {
    /// The robot became autonomous (§3.3.5).
    GoHome {
        /// The strategy's name.
        strategy: String,
        /// Metres in a straight line to where home is believed to be.
        distance: Option<f64>,
        /// Surfaces that navigation no longer trusts from here on; the map keeps them.
        dropped: usize,
    },
    /// Another way on was chosen than before.
    OptionChosen {
        /// Where it leads, in the map, metres.
        end: [f64; 2],
        /// How many there were to choose from.
        options: usize,
        /// One sentence for people.
        why: Sentence,
    },
    /// A way that had seemed open turned out to be closed; it will be remembered.
    DeadEnd {
        /// Where, in the map, metres.
        position: [f64; 2],
        /// One sentence for people.
        why: Sentence,
    },
    /// The fail-safe took over: the remembered route is followed (§3.3.4).
    FailsafeOn {
        /// One sentence for people.
        why: Sentence,
    },
    /// The sense of direction leads again.
    FailsafeOff {
        /// One sentence for people.
        why: Sentence,
    },
    /// The robot stopped by itself: home is here, as far as it can tell.
    Home {
        /// Metres to where home is believed to be.
        distance: f64,
    },
    /// The robot gave up and waits for the user.
    Stuck {
        /// One sentence for people.
        why: Sentence,
    },
}
