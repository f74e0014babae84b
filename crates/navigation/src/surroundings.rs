use cogmap_geometry::{DVec2, Segment, trig};

/// Directions that a [`Fan`] looks in: one each half degree.
const BEARINGS: usize = 720;
/// Surfaces are looked at in points this far apart, metres.
const SPACING: f64 = 0.1;

/// What stands around the robot as far as it trusts its memory and its eyes, in the coordinates of the
/// place where it is.
#[derive(Clone, Debug, Default)]
pub(crate) struct Surroundings {
    pub(crate) surfaces: Vec<Segment>,
    /// What the present view adds.
    pub(crate) points: Vec<DVec2>,
}

impl Surroundings {
    /// Whether a disc can travel along a line without touching anything.
    pub(crate) fn leave_free(&self, way: Segment, radius: f64) -> bool {
        let (low, high) = (way.a.min(way.b) - radius, way.a.max(way.b) + radius);
        let beside = |least: DVec2, most: DVec2| most.cmplt(low).any() || least.cmpgt(high).any();
        let free = |surface: &Segment| {
            beside(surface.a.min(surface.b), surface.a.max(surface.b)) || between(*surface, way) >= radius
        };
        self.points.iter().all(|&point| beside(point, point) || way.distance_to(point) >= radius)
            && self.surfaces.iter().all(free)
    }

    /// Where a disc that travels along a line would first touch something.
    pub(crate) fn first_touch(&self, way: Segment, radius: f64) -> Option<DVec2> {
        if self.leave_free(way, radius) {
            return None;
        }
        let pieces = (way.length() / SPACING).ceil().max(1.0);
        let at = |k: f64| way.a.lerp(way.b, k / pieces);
        let free = |k: f64| self.leave_free(Segment::new(way.a, at(k + 1.0)), radius);
        let mut k = 0.0;
        while k + 1.0 < pieces && free(k) {
            k += 1.0;
        }
        Some(at(k))
    }

    /// Everything as points.
    fn samples(&self) -> impl Iterator<Item = DVec2> + '_ {
        let along = |surface: &Segment| {
            let (surface, pieces) = (*surface, (surface.length() / SPACING).ceil().max(1.0));
            (0..=pieces as usize).map(move |k| surface.a.lerp(surface.b, k as f64 / pieces))
        };
        self.surfaces.iter().flat_map(along).chain(self.points.iter().copied())
    }
}

/// Metres between two segments.
fn between(a: Segment, b: Segment) -> f64 {
    if a.crossing(b).is_some() {
        return 0.0;
    }
    let ends_of_a = b.distance_to(a.a).min(b.distance_to(a.b));
    ends_of_a.min(a.distance_to(b.a)).min(a.distance_to(b.b))
}

/// How far a disc can travel straight on in each direction.
pub(crate) struct Fan {
    directions: Vec<DVec2>,
    /// Metres, one a direction, counter-clockwise.
    reach: Vec<f64>,
}

/// The disc that travels, and how far it looks.
#[derive(Clone, Copy)]
pub(crate) struct Sweep {
    /// Metres.
    pub(crate) radius: f64,
    /// What is kept between the disc and what is ahead of it, metres.
    pub(crate) gap: f64,
    /// The farthest travel, metres.
    pub(crate) sight: f64,
}

impl Fan {
    pub(crate) fn of(surroundings: &Surroundings, from: DVec2, sweep: Sweep) -> Self {
        let direction = |k: usize| {
            let (sin, cos) = trig::sin_cos(k as f64 * trig::TAU / BEARINGS as f64);
            DVec2::new(cos, sin)
        };
        let directions = (0..BEARINGS).map(direction).collect();
        let mut fan = Self { directions, reach: vec![sweep.sight; BEARINGS] };
        for point in surroundings.samples() {
            fan.cut(point - from, sweep);
        }
        fan
    }

    /// Shortens what a point stands in the way of.
    fn cut(&mut self, point: DVec2, Sweep { radius, gap, sight }: Sweep) {
        let distance = point.length();
        if distance > sight + radius + gap {
            return;
        }
        let half = if distance > radius { trig::asin(radius / distance) } else { trig::FRAC_PI_2 };
        let per_bearing = BEARINGS as f64 / trig::TAU;
        let bearing = trig::atan2(point.y, point.x);
        let first = ((bearing - half) * per_bearing).ceil() as i64;
        let last = ((bearing + half) * per_bearing).floor() as i64;
        for k in first..=last {
            let k = k.rem_euclid(BEARINGS as i64) as usize;
            let direction = self.directions[k];
            let (ahead, beside) = (direction.dot(point), direction.perp_dot(point));
            if ahead > 0.0 && beside.abs() < radius {
                let touch = ahead - (radius * radius - beside * beside).sqrt() - gap;
                self.reach[k] = self.reach[k].min(touch.max(0.0));
            }
        }
    }

    pub(crate) fn direction(&self, k: usize) -> DVec2 {
        self.directions[k]
    }

    pub(crate) fn reach(&self, k: usize) -> f64 {
        self.reach[k]
    }

    /// The direction nearest to a vector's.
    pub(crate) fn toward(&self, vector: DVec2) -> usize {
        let turns = trig::atan2(vector.y, vector.x) / trig::TAU;
        ((turns * BEARINGS as f64).round() as i64).rem_euclid(BEARINGS as i64) as usize
    }

    /// The openings: runs of directions between two depth edges, where the reach jumps by more than `edge`
    /// metres. Each is its first direction and their number.
    pub(crate) fn openings(&self, edge: f64) -> Vec<(usize, usize)> {
        let before = |k: usize| self.reach[(k + BEARINGS - 1) % BEARINGS];
        let starts: Vec<usize> =
            (0..BEARINGS).filter(|&k| (self.reach[k] - before(k)).abs() > edge).collect();
        let Some(&first) = starts.first() else { return vec![(0, BEARINGS)] };
        let ends = starts.iter().skip(1).copied().chain([first + BEARINGS]);
        starts.iter().zip(ends).map(|(&start, end)| (start, end - start)).collect()
    }

    /// Some directions of an opening: its two edges and, between them, the middles of equal shares of at
    /// most `width` radians.
    pub(crate) fn directions_in(&self, (start, count): (usize, usize), width: f64) -> Vec<usize> {
        let shares = (count as f64 * trig::TAU / BEARINGS as f64 / width).ceil().max(1.0) as usize;
        let middles = (0..shares).map(|share| start + (2 * share + 1) * count / (2 * shares));
        let all = [start, start + count - 1].into_iter().chain(middles);
        all.map(|k| k % BEARINGS).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wall(x1: f64, y1: f64, x2: f64, y2: f64) -> Segment {
        Segment::new(DVec2::new(x1, y1), DVec2::new(x2, y2))
    }

    const DISC: Sweep = Sweep { radius: 0.3, gap: 0.0, sight: 8.0 };

    #[test]
    fn a_disc_stops_a_radius_before_a_wall() {
        let room = Surroundings { surfaces: vec![wall(2.0, -3.0, 2.0, 3.0)], points: Vec::new() };
        let fan = Fan::of(&room, DVec2::ZERO, DISC);
        assert!((fan.reach(0) - 1.7).abs() < 0.01, "{}", fan.reach(0));
        assert!((fan.reach(BEARINGS / 2) - 8.0).abs() < 1e-12, "behind it is free");
        let touch = room.first_touch(wall(0.0, 0.0, 5.0, 0.0), 0.3).unwrap();
        assert!((touch.x - 1.7).abs() < 0.11, "{touch}");
    }

    #[test]
    fn a_gap_counts_only_if_the_disc_fits_through() {
        for (gap, openings) in [(0.5, 1), (0.7, 3)] {
            let sides = [wall(2.0, -9.0, 2.0, -gap / 2.0), wall(2.0, gap / 2.0, 2.0, 9.0)];
            let rest = [wall(-2.0, -9.0, -2.0, 9.0), wall(-2.0, 9.0, 2.0, 9.0), wall(-2.0, -9.0, 2.0, -9.0)];
            let surfaces = sides.into_iter().chain(rest).collect();
            let fan = Fan::of(&Surroundings { surfaces, points: Vec::new() }, DVec2::ZERO, DISC);
            let through = fan.openings(1.0).iter().filter(|&&(k, _)| fan.reach(k) > 3.0).count();
            assert_eq!(through > 0, openings > 1, "a gap of {gap} m");
            assert_eq!(fan.reach(0) > 3.0, gap > 0.6);
        }
    }

    #[test]
    fn an_obstacle_at_ones_back_does_not_hold_one() {
        let point = Surroundings { surfaces: Vec::new(), points: vec![DVec2::new(-0.2, 0.0)] };
        let fan = Fan::of(&point, DVec2::ZERO, DISC);
        assert!(fan.reach(0) > 7.9 && fan.reach(BEARINGS / 2) < 1e-12);
    }
}
