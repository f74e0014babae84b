use cogmap_geometry::DVec2;
use cogmap_mapping::{Placement, perception::View};

use super::{Values, count};
use crate::{Drive, Mapping};

/// A surface this long tells a direction, metres.
const TELLING: f64 = 0.5;
/// Two surfaces tell where the robot is if they are turned against each other by this, radians.
const CROSSING: f64 = 15.0 * cogmap_geometry::trig::PI / 180.0;

/// How often odometry decided, and whether it had to.
pub(super) fn score(mapping: &Mapping, values: &mut Values) {
    let reports = &mapping.reports;
    values.put("views", count(reports.len()));
    values.put("views_stored", count(reports.iter().filter(|report| report.stored).count()));
    if mapping.mapper.is_odometry() {
        return;
    }
    let placed_by = |by| reports.iter().filter(move |report| report.placement == by);
    values.put("weak", count(placed_by(Placement::WeakReference).count()));
    let excused = |k: &usize| !tells(&reports[*k].view) || (*k > 0 && !tells(&reports[*k - 1].view));
    for (by, name, name_excused) in [
        (Placement::Odometry, "fallbacks", "fallbacks_excused"),
        (Placement::PartlyOdometry, "partly", "partly_excused"),
    ] {
        let such: Vec<usize> = (0..reports.len()).filter(|&k| reports[k].placement == by).collect();
        values.put(name, count(such.len()));
        values.put(name_excused, count(such.iter().filter(|k| excused(k)).count()));
    }
}

/// How far odometry carried the robot at most.
pub(super) fn score_way(drive: &Drive, mapping: &Mapping, values: &mut Values) {
    if !mapping.mapper.is_odometry() {
        values.put("longest_fallback", longest_fallback(drive, mapping));
    }
}

/// Whether a view could tell where the robot is: two surfaces in it stand across each other.
fn tells(view: &View) -> bool {
    let telling: Vec<_> = view.surfaces.iter().filter(|surface| surface.length() >= TELLING).collect();
    let crossed = |first: &cogmap_mapping::perception::Surface| {
        telling.iter().any(|second| first.segment.angle_to(second.segment) >= CROSSING)
    };
    telling.iter().any(|surface| crossed(surface))
}

/// Metres of the true way on the longest stretch of views that odometry alone placed.
fn longest_fallback(drive: &Drive, mapping: &Mapping) -> f64 {
    let views = mapping.reports.iter().zip(&mapping.look_of_report);
    let (mut longest, mut stretch, mut last): (f64, f64, Option<DVec2>) = (0.0, 0.0, None);
    for (report, &look) in views {
        let here = drive.looks[look].world_from_robot.position;
        let moved = last.map_or(0.0, |last| last.distance(here));
        stretch = if report.placement == Placement::Odometry { stretch + moved } else { 0.0 };
        longest = longest.max(stretch);
        last = Some(here);
    }
    longest
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::{DVec2, Segment};
    use cogmap_mapping::perception::{End, Surface};

    use super::*;

    fn view(walls: &[[f64; 4]]) -> View {
        let surface = |&[ax, ay, bx, by]: &[f64; 4]| Surface {
            segment: Segment::new(DVec2::new(ax, ay), DVec2::new(bx, by)),
            ends: [End::True; 2],
            beams: [0, 9],
            points: 10,
            residual: 0.0,
            range: 3.0,
            incidence: 0.3,
            label: None,
        };
        View { surfaces: walls.iter().map(surface).collect() }
    }

    #[test]
    fn the_walls_of_a_corridor_do_not_tell_where_along_it_the_robot_is() {
        let corridor = [[0.0, 1.0, 8.0, 1.0], [8.0, -1.0, 0.0, -1.0]];
        assert!(!tells(&view(&corridor)));
        assert!(!tells(&view(&[])));
        let with_leg = [corridor[0], corridor[1], [5.0, 0.0, 5.0, 0.2]];
        assert!(!tells(&view(&with_leg)), "debris is no direction");
        let with_end = [corridor[0], corridor[1], [8.0, -1.0, 8.0, 1.0]];
        assert!(tells(&view(&with_end)));
    }
}
