//! Following a known path from memory, and leaving it (§3.3.4).

use cogmap_geometry::{DVec2, Segment};
use cogmap_navigation::{FaithfulParams, HomingEvent};
use cogmap_scene::{Annotation, Sample};

use super::{
    Drawing, Runs,
    draw::{ring, role},
    mind::{Frame, Show, decided, mind_of, panel, source},
    outings::{BOXES, HALLS},
    runs::Run,
};

/// Fig. 3.33.
pub(super) fn waypoints(runs: &mut Runs) -> Result<Drawing, String> {
    let gives_up = |event: &HomingEvent| matches!(event, HomingEvent::FailsafeOn { .. });
    let out = runs.of(&BOXES)?;
    let run = out.homeward(FaithfulParams::default(), |_, decision| decision.events.iter().any(gives_up));
    let views = run.session.mappers().first().map_or(0, |mind| mind.path().len());
    Ok(Drawing {
        panels: vec![panel("", mind_of(&run, Show::Decision), Frame::of([-0.3, -0.3], [22.6, 9.3]), &[])],
        columns: 1,
        outcome: format!(
            "Here {} waypoints stand for {:.0} m and {views} views.",
            decided(&run)?.waypoints.len(),
            out.length()
        ),
        source: source(&run),
    })
}

/// The doorways of the halls that the way out passes by, from jamb to jamb.
const DOORWAYS: [[[f64; 2]; 2]; 2] = [[[5.4, 7.76], [6.8, 7.76]], [[8.6, 3.76], [10.0, 3.76]]];

/// Fig. 3.34.
pub(super) fn two_shortcuts(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&HALLS)?.homeward(FaithfulParams::default(), |_, _| false);
    let way = run.session.way_home().ok_or("the robot did not go home")?;
    let taken: Vec<DVec2> = DOORWAYS
        .iter()
        .map(|[a, b]| Segment::new((*a).into(), (*b).into()))
        .filter(|doorway| goes_through(&run, *doorway))
        .map(Segment::midpoint)
        .collect();
    let mut scene = mind_of(&run, Show::Journey);
    scene.still.extend(taken.iter().map(|&place| ring(place, 1.0)));
    let more = [(Sample::Line(role(Annotation::Ring)), "a shortcut")];
    Ok(Drawing {
        panels: vec![panel("", scene, Frame::of([-0.3, -0.3], [14.3, 11.94]), &more)],
        columns: 1,
        outcome: format!(
            "Here it takes {}: {:.0} m home after {:.0} m out. In the thesis’s figure the robot leaves the known route \
             for them; here its sense of direction leads from the first step on.",
            ["none of them", "one of them", "both"][taken.len()],
            way.way_home,
            way.way_out
        ),
        source: source(&run),
    })
}

/// Whether the robot went through a doorway on its way home.
fn goes_through(run: &Run, doorway: Segment) -> bool {
    let journal = run.session.journal();
    let begun = journal.homings.first().map_or(0, |home| home.scans);
    let track: Vec<DVec2> = journal.truth.iter().skip(begun).map(|stamped| stamped.pose.position).collect();
    track.windows(2).any(|pair| Segment::new(pair[0], pair[1]).crossing(doorway).is_some())
}
