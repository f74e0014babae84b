//! Deciding which way to go (§3.3.2).

use cogmap_geometry::{DVec2, Segment};
use cogmap_navigation::{Act, Decision, FaithfulParams};
use cogmap_simulation::Session;

use super::{
    Drawing, Runs,
    mind::{Frame, Show, decided, mind_of, open, panel, source, without_choice},
    outings::{BOXES, CORNER, POCKET},
    runs::{Outing, Run},
};

/// Few options.
const FEW: usize = 2;
/// Many options.
const MANY: usize = 7;

/// The hall behind the boxes.
const HALL: Frame = Frame::of([-0.2, -0.2], [13.6, 9.2]);

/// The robot on its way home, when it has just decided something.
fn moment(
    runs: &mut Runs,
    outing: &Outing,
    wanted: impl Fn(&Session, &Decision) -> bool,
) -> Result<Run, String> {
    Ok(runs.of(outing)?.homeward(FaithfulParams::default(), wanted))
}

fn counted(decision: &Decision) -> String {
    match open(decision) {
        1 => "Here there is one.".to_owned(),
        many => format!("Here there are {many}."),
    }
}

/// Fig. 3.25.
pub(super) fn in_a_narrow_place(runs: &mut Runs) -> Result<Drawing, String> {
    let goes = |decision: &Decision| matches!(decision.act, Act::Step { travel, .. } if travel > 0.0);
    let run = moment(runs, &CORNER, |_, decision| goes(decision) && open(decision) <= FEW)?;
    let scene = without_choice(mind_of(&run, Show::Decision));
    Ok(Drawing {
        panels: vec![panel("", scene, Frame::of([-0.2, -0.2], [8.2, 7.6]), &[])],
        columns: 1,
        outcome: counted(decided(&run)?),
        source: source(&run),
    })
}

/// The robot where the boxes lie behind it and the hall before it.
fn in_the_hall(runs: &mut Runs) -> Result<Run, String> {
    moment(runs, &BOXES, |_, decision| open(decision) >= MANY)
}

/// Fig. 3.26.
pub(super) fn in_a_wide_place(runs: &mut Runs) -> Result<Drawing, String> {
    let run = in_the_hall(runs)?;
    let scene = without_choice(mind_of(&run, Show::Decision));
    Ok(Drawing {
        panels: vec![panel("", scene, HALL, &[])],
        columns: 1,
        outcome: counted(decided(&run)?),
        source: source(&run),
    })
}

/// Fig. 3.27.
pub(super) fn out_of_a_dead_end(runs: &mut Runs) -> Result<Drawing, String> {
    let goes = |decision: &Decision| matches!(decision.act, Act::Step { travel, .. } if travel > 0.0);
    let run = moment(runs, &POCKET, |_, decision| goes(decision))?;
    let scene = without_choice(mind_of(&run, Show::Decision));
    let (through, all) = (through_forgotten(&run, decided(&run)?), open(decided(&run)?));
    let which = if through == all { format!("all {all}") } else { format!("{through} of {all}") };
    Ok(Drawing {
        panels: vec![panel("", scene, Frame::of([-0.2, 1.8], [20.2, 10.2]), &[])],
        columns: 1,
        outcome: format!(
            "Here {which} assumed ways go through a wall that the robot saw on its way out and has forgotten. It \
             hopes that there is a way, and will see the wall again."
        ),
        source: source(&run),
    })
}

/// How many assumed ways on cross something that the robot does not trust any more.
fn through_forgotten(run: &Run, decision: &Decision) -> usize {
    let homing = run.session.homing().and_then(|pilot| pilot.homing());
    let (Some(homing), Some(mind), Some(home)) = (homing, run.session.mappers().first(), decision.home)
    else {
        return 0;
    };
    let mfis = mind.mfis();
    let forgotten: Vec<Segment> = mfis
        .remembered()
        .filter(|surface| !homing.trusts(surface.id))
        .map(|surface| mfis.in_map(surface))
        .collect();
    let map_from_here = mfis.map_from_frame(decision.frame);
    let crosses = |end: DVec2| {
        let assumed = map_from_here * Segment::new(end, home);
        forgotten.iter().any(|surface| surface.crossing(assumed).is_some())
    };
    decision.options.iter().filter(|option| !option.barred && crosses(option.end)).count()
}

/// Fig. 3.28.
pub(super) fn the_most_promising(runs: &mut Runs) -> Result<Drawing, String> {
    let run = in_the_hall(runs)?;
    let decision = decided(&run)?;
    let detours = decision.options.iter().filter(|option| !option.barred).map(|option| option.detour);
    let (least, most) = detours.fold((f64::INFINITY, 0.0), |(least, most), detour| {
        (f64::min(least, detour), f64::max(most, detour))
    });
    Ok(Drawing {
        panels: vec![panel("", mind_of(&run, Show::Decision), HALL, &[])],
        columns: 1,
        outcome: format!(
            "Here its way is {least:.2} m longer than the straight line, the worst of the others {most:.2} m."
        ),
        source: source(&run),
    })
}
