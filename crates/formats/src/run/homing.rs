use cogmap_mapping::Sentence;
use cogmap_navigation::{HomingEvent, HomingParams, Mode, StrategySetup};
use cogmap_simulation::{Ending, Session, Strategy};
use serde::Serialize;

/// The last way home in numbers, and every parameter that it went by.
#[derive(Serialize)]
pub(super) struct HomingNote<'a> {
    strategy: &'static str,
    /// `home`, `stuck` or `stopped`; none while the robot is on its way.
    ending: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    why: Option<&'a Sentence>,
    /// Metres to where the run began, in truth and as the robot believes.
    distance: f64,
    believed_distance: Option<f64>,
    /// Metres driven until the robot was told to go home, and since.
    way_out: f64,
    way_home: f64,
    /// Metres of the way on which a person would have led it who sees the building.
    shortest: Option<f64>,
    decisions: Decisions,
    dead_ends: usize,
    failsafes: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    parameters: Option<Parameters<'a>>,
}

/// How many decisions, by what led the robot.
#[derive(Serialize)]
struct Decisions {
    direction: usize,
    route: usize,
    planning: usize,
}

#[derive(Serialize)]
struct Parameters<'a> {
    homing: HomingParams,
    strategy: &'a StrategySetup,
}

/// What the report says of the last way home; `None` where the robot was never told to go home.
pub(super) fn homing_note(session: &Session) -> Option<HomingNote<'_>> {
    let way = session.way_home()?;
    let led_by = |mode: Mode| way.decisions.iter().filter(|decision| decision.mode == mode).count();
    let count = |wanted: fn(&HomingEvent) -> bool| {
        way.decisions.iter().flat_map(|decision| &decision.events).filter(|event| wanted(event)).count()
    };
    let (ending, why) = match way.ending {
        Some(Ending::Home) => (Some("home"), None),
        Some(Ending::Stuck(why)) => (Some("stuck"), Some(why)),
        Some(Ending::Stopped) => (Some("stopped"), None),
        None => (None, None),
    };
    Some(HomingNote {
        strategy: way.strategy.name(),
        ending,
        why,
        distance: way.distance,
        believed_distance: way.believed,
        way_out: way.way_out,
        way_home: way.way_home,
        shortest: way.shortest,
        decisions: Decisions {
            direction: led_by(Mode::Direction),
            route: led_by(Mode::Route),
            planning: led_by(Mode::Planning),
        },
        dead_ends: count(|event| matches!(event, HomingEvent::DeadEnd { .. })),
        failsafes: count(|event| matches!(event, HomingEvent::FailsafeOn { .. })),
        parameters: match way.strategy {
            Strategy::Robot(strategy) => Some(Parameters { homing: HomingParams::default(), strategy }),
            Strategy::Oracle => None,
        },
    })
}
