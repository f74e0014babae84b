use cogmap_geometry::DVec2;
use cogmap_mapping::Placement;
use cogmap_scene::{Bounds, Role, Sample, WorldOptions, world_scene};
use cogmap_simulation::Session;

use super::{
    Drawing, Runs,
    draw::{panel, robot, surfaces},
    maps::panel_of,
    outings::CORRIDOR,
};

/// The robot has to come so far before the moment is worth a picture, metres: well into the corridor.
const WELL_INSIDE: f64 = 11.0;

/// Whether the robot, in the middle of the corridor, has nothing to go by.
fn nothing_to_go_by(session: &Session) -> bool {
    let truth = &session.journal().truth;
    let start = truth.first().map_or(DVec2::ZERO, |first| first.pose.position);
    let far = truth.last().is_some_and(|last| last.pose.position.distance(start) > WELL_INSIDE);
    let reports = session.journal().mappers.first().map_or(&[][..], |journal| &journal.reports);
    far && reports.last().is_some_and(|report| report.placement == Placement::Odometry)
}

/// Fig. 3.21.
pub(super) fn nothing_in_view(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.until(&CORRIDOR, nothing_to_go_by)?;
    let (_, journal) = run.mind("perceptual")?;
    let report = journal.reports.last().ok_or("the robot took no view")?;
    let place = run.truth_of(report);
    let items =
        vec![surfaces(Role::SurfaceOfView(0), place, &report.view.surfaces), robot(Role::Robot, place)];
    let legend = [(Sample::Line(Role::SurfaceOfView(0)), "surface in view")];
    let world =
        world_scene(&run.session, WorldOptions { laser: true, path: true, labels: true, home: false });
    let Bounds { min, max } = world.bounds().ok_or("the world is empty")?;
    let strip = Bounds {
        min: DVec2::new(min.x, place.position.y - 1.2),
        max: DVec2::new(max.x, place.position.y + 1.2),
    };
    let view = report.step + 1;
    let outcome = match report.placement {
        Placement::Odometry => format!("View {view} has no reference: this one is placed by odometry."),
        _ => "In this run something was recognised all the same.".to_owned(),
    };
    Ok(Drawing {
        panels: vec![
            panel_of("Where it is", world),
            cogmap_scene::Panel { room: Some(strip), ..panel("What it has to go by", items, &legend) },
        ],
        columns: 1,
        outcome,
        source: format!("the perceptual mapper, {}", run.words()),
    })
}
