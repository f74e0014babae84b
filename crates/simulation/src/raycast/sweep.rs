use cogmap_geometry::{DVec2, Segment};

use super::{
    Disc, Hit,
    beams::{Beams, End},
    frame::Frame,
    solid::Solid,
};

/// Metres within which a solid counts as touching the sensor: all beams meet it
/// at once.
const TOUCH: f64 = 1e-9;
/// Recently laid solids remembered, so that one listed in many cells is laid
/// once.
const SEEN: usize = 256;

/// Solids being laid onto the beams of one quadrant.
pub(super) struct Sweep {
    pub(super) frame: Frame,
    pub(super) beams: Beams,
    seen: [u32; SEEN],
}

impl Sweep {
    /// With nothing laid yet on `beams`.
    pub(super) fn new(frame: Frame, beams: Beams) -> Self {
        Self { frame, beams, seen: [u32::MAX; SEEN] }
    }

    /// Lets the beams meet `solid`, known as `id`, where it is the nearest.
    pub(super) fn lay(&mut self, id: u32, solid: &Solid) {
        let seen = &mut self.seen[id as usize % SEEN];
        if *seen == id {
            return;
        }
        *seen = id;
        match solid {
            Solid::Segment(segment) => self.lay_segment(id, segment),
            Solid::Disc(disc) => self.lay_disc(id, disc),
        }
    }

    fn lay_segment(&mut self, id: u32, segment: &Segment) {
        let (a, b) = (self.frame.point(segment.a), self.frame.point(segment.b));
        if a.x < -TOUCH && b.x < -TOUCH {
            return;
        }
        let along = self.frame.vector(segment.b - segment.a);
        let cross = a.perp_dot(along);
        if cross * cross <= TOUCH * TOUCH * along.length_squared() {
            return self.lay_edge_on(id, a, b);
        }
        let (right, left) = if cross > 0.0 { (a, b) } else { (b, a) };
        if let Some([right, left]) = slopes(right, left) {
            let (constant, linear) = (along.y / cross, -along.x / cross);
            self.beams.meet(self.beams.between(right, left), id, |slope| constant + linear * slope);
        }
    }

    /// A segment on a line through the sensor: only its nearer end can be met.
    fn lay_edge_on(&mut self, id: u32, a: DVec2, b: DVec2) {
        if Segment::new(a, b).distance_to(DVec2::ZERO) <= TOUCH {
            return self.lay_touching(id);
        }
        let near = if a.length_squared() < b.length_squared() { a } else { b };
        if near.x > 0.0 {
            let slope = near.y / near.x;
            self.beams.meet(self.beams.between(slope, slope), id, |_| 1.0 / near.x);
        }
    }

    fn lay_touching(&mut self, id: u32) {
        self.beams.meet(self.beams.all(), id, |_| f64::INFINITY);
    }

    fn lay_disc(&mut self, id: u32, disc: &Disc) {
        let (center, radius) = (self.frame.point(disc.center), disc.radius);
        let distance = center.length();
        let power = (distance - radius) * (distance + radius);
        // A beam meets the circle where power·n² - 2·toward·n + (1 + slope²) = 0.
        let toward = |slope: f64| center.x + center.y * slope;
        let root = |slope: f64| {
            let squared = toward(slope) * toward(slope) - power * (1.0 + slope * slope);
            squared.max(0.0).sqrt()
        };
        if (distance - radius).abs() <= TOUCH {
            self.lay_touching(id);
        } else if power < 0.0 {
            let nearness = |slope: f64| (1.0 + slope * slope) / (toward(slope) + root(slope));
            self.beams.meet(self.beams.all(), id, nearness);
        } else {
            let (out, aside) = (center * power.sqrt(), center.perp() * radius);
            if let Some([right, left]) = slopes(out - aside, out + aside) {
                let nearness = |slope: f64| (toward(slope) + root(slope)) / power;
                self.beams.meet(self.beams.between(right, left), id, nearness);
            }
        }
    }

    /// Appends what each beam met, looking solids up by their id.
    pub(super) fn collect<'a>(
        &self,
        solid: impl Fn(usize) -> Option<&'a Solid>,
        hits: &mut Vec<Option<Hit>>,
    ) {
        for (beams, id) in self.beams.runs() {
            let Some((id, met)) = id.and_then(|id| Some((id, solid(id as usize)?))) else {
                hits.resize(hits.len() + beams.len(), None);
                continue;
            };
            let facing = Facing::of(met, self.frame);
            hits.extend(self.beams.ends(beams).map(|end| {
                Some(Hit { range: end.range, solid: id, incidence_cos: facing.incidence_cos(&end) })
            }));
        }
    }
}

/// What a solid's surface looks like from a frame.
#[derive(Clone, Copy)]
enum Facing {
    /// Straight, with this unit normal.
    Straight(DVec2),
    /// Round, with this center and radius.
    Round(DVec2, f64),
}

impl Facing {
    fn of(solid: &Solid, frame: Frame) -> Self {
        match solid {
            Solid::Segment(s) => Self::Straight(frame.vector(s.b - s.a).perp().normalize_or_zero()),
            Solid::Disc(d) => Self::Round(frame.point(d.center), d.radius),
        }
    }

    fn incidence_cos(self, end: &End) -> f64 {
        let normal = match self {
            Self::Straight(normal) => normal,
            Self::Round(center, radius) => (end.direction * end.range - center) / radius.max(TOUCH),
        };
        let cos = normal.dot(end.direction).abs();
        if cos < 1.0 { cos } else { 1.0 }
    }
}

/// Slopes of the directions `right` and `left`, less than half a turn apart and
/// counter-clockwise in this order; `None` where nothing between is ahead.
fn slopes(right: DVec2, left: DVec2) -> Option<[f64; 2]> {
    let slope = |end: DVec2, behind: f64| if end.x > 0.0 { end.y / end.x } else { behind };
    let ahead = right.x > 0.0 || left.x > 0.0;
    ahead.then(|| [slope(right, f64::NEG_INFINITY), slope(left, f64::INFINITY)])
}
