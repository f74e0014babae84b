use cogmap_geometry::{DVec2, Segment};

/// How many steps of the way that the robot drove would run into a surface of its map: a disc of
/// that radius, moved along the way as the map has it, touches one.
#[must_use]
pub fn blocked_steps(way: &[DVec2], surfaces: &[Segment], radius: f64) -> usize {
    let steps = way.windows(2).map(|ends| Segment::new(ends[0], ends[1]));
    steps.filter(|step| surfaces.iter().any(|surface| near(*step, *surface, radius))).count()
}

fn near(step: Segment, surface: Segment, radius: f64) -> bool {
    let (low, high) = (step.a.min(step.b) - radius, step.a.max(step.b) + radius);
    let apart = surface.a.max(surface.b).cmplt(low) | surface.a.min(surface.b).cmpgt(high);
    !apart.any() && distance(step, surface) < radius
}

/// Metres between the two nearest points of two lines.
fn distance(first: Segment, second: Segment) -> f64 {
    if first.crossing(second).is_some() {
        return 0.0;
    }
    let to_second = second.distance_to(first.a).min(second.distance_to(first.b));
    to_second.min(first.distance_to(second.a)).min(first.distance_to(second.b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_duplicate_across_the_way_blocks_the_one_step_that_meets_it() {
        let way = [DVec2::ZERO, DVec2::new(1.0, 0.0), DVec2::new(2.0, 0.0), DVec2::new(2.0, 1.0)];
        let line = |ax, ay, bx, by| Segment::new(DVec2::new(ax, ay), DVec2::new(bx, by));
        let beside = line(-1.0, 0.26, 1.7, 0.26);
        let across = line(1.5, -1.0, 1.5, 1.0);
        let at_the_end = line(1.9, 1.24, 2.1, 1.24);
        assert_eq!(blocked_steps(&way, &[beside], 0.25), 0);
        assert_eq!(blocked_steps(&way, &[beside, across], 0.25), 1);
        assert_eq!(blocked_steps(&way, &[beside, across, at_the_end], 0.25), 2);
        assert_eq!(blocked_steps(&way[..1], &[across], 0.25), 0);
    }
}
