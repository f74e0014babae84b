//! What was tried and led nowhere (§3.3.3).

use cogmap_navigation::{Act, Decision, FaithfulParams, HomingEvent, Mode};
use cogmap_simulation::Session;

use super::{
    Drawing, Runs,
    mind::{Frame, Show, decided, mind_of, panel, source},
    outings::BAY,
    runs::Run,
};

/// Where the bay begins, and where it ends, metres.
const BAY_FROM: f64 = 7.9;
const BAY_TO: f64 = 17.0;
/// The robot without a memory of dead ends is watched until it has come out of the bay so often.
const TIMES: usize = 2;

/// Without a memory of dead ends or with it.
fn params(dead_ends: bool) -> FaithfulParams {
    FaithfulParams { dead_ends, ..FaithfulParams::default() }
}

fn x(session: &Session) -> f64 {
    session.world_from_robot().map_or(0.0, |robot| robot.position.x)
}

/// How often the robot has turned back to its sense of direction after it had come out of the bay.
fn turned_back(session: &Session) -> usize {
    let off = |decision: &&Decision| {
        decision.events.iter().any(|event| matches!(event, HomingEvent::FailsafeOff { .. }))
    };
    session.journal().decisions.iter().filter(off).count()
}

/// Fig. 3.31.
pub(super) fn away_from_it(runs: &mut Runs) -> Result<Drawing, String> {
    let goes = |act: Act| matches!(act, Act::Step { travel, .. } if travel > 0.0);
    let leaves = |decision: &Decision| decision.mode == Mode::Route && goes(decision.act);
    let run = runs.of(&BAY)?.homeward(params(false), |_, decision| leaves(decision));
    let outcome = if decided(&run)?.mode == Mode::Route {
        format!(
            "It saw the end from {:.0} m away and turns back. The thesis’s robot is led away by its sense of \
             direction; here no option is left, and the remembered route leads out.",
            seen_from(&run)
        )
    } else {
        "In this run it does not go in.".to_owned()
    };
    Ok(Drawing {
        panels: vec![panel("", mind_of(&run, Show::Decision), Frame::of([-0.2, -0.2], [27.2, 13.2]), &[])],
        columns: 1,
        outcome,
        source: source(&run),
    })
}

/// How far the robot was from the end of the bay when it came nearest, metres.
fn seen_from(run: &Run) -> f64 {
    let truth = run.session.journal().truth.iter();
    let inside = truth.filter(|it| it.pose.position.y < 7.8).map(|it| it.pose.position.x);
    BAY_TO - inside.filter(|&x| x < BAY_TO).fold(BAY_FROM, f64::max)
}

/// Fig. 3.32.
pub(super) fn into_it_again(runs: &mut Runs) -> Result<Drawing, String> {
    let out = runs.of(&BAY)?;
    let without = out.homeward(params(false), |session, _| turned_back(session) == TIMES);
    let with = out.homeward(params(true), |session, _| turned_back(session) == 1);
    let barred = decided(&with)?.options.iter().filter(|option| option.barred).count();
    let above = if turned_back(&without.session) == TIMES {
        let far = BAY_TO - x(&without.session);
        format!(
            "Above it is about to go into the bay for the third time: its end, {far:.0} m away, is forgotten."
        )
    } else {
        "Above, in this run, it does not come back to it so often.".to_owned()
    };
    let below = format!(
        "Below it keeps a rough mark of what it tried: {barred} options are barred, and it goes round."
    );
    let frame = Frame { rows: 2, ..Frame::of([-0.2, 1.7], [25.4, 11.2]) };
    let panels = [(&without, "Without a memory of dead ends"), (&with, "With it")];
    Ok(Drawing {
        panels: panels
            .map(|(run, heading)| panel(heading, mind_of(run, Show::DecisionAndPath), frame, &[]))
            .into(),
        columns: 1,
        outcome: format!("{above} {below}"),
        source: source(&with),
    })
}
