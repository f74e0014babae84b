mod floor;

use cogmap_geometry::{DVec2, Segment};

use super::{Asr, Exit, Network};
use crate::memory::{Memory, StoredSurface};
use floor::Floor;

/// Metres around each place where the robot stood that are taken to be free, about its size.
const STANDING_ROOM: f64 = 0.4;

/// The outline of a local space in its own frame, metres, counter-clockwise: around the floor between
/// where the robot stood and the surfaces of that space which it saw from there, up to the exits. Empty
/// where nothing was seen. The theory says what an ASR contains (§2.2.1), not how it is outlined: this is ours.
#[must_use]
pub fn outline(asr: &Asr, network: &Network, memory: &Memory) -> Vec<DVec2> {
    let asr_from_map = memory.mfis().map_from_frame(asr.frame).inverse();
    let sights = sights(asr, network, memory);
    let stands = memory.path().iter().filter(|point| network.asr_at(point.step) == Some(asr.id));
    let stands: Vec<DVec2> = stands.map(|point| memory.mfis().place_of(point).position).collect();
    let seen = sights.iter().flat_map(|sight| [sight.from, sight.seen.a, sight.seen.b]);
    let Some(mut floor) = Floor::around(seen.chain(stands.iter().copied()), STANDING_ROOM) else {
        return Vec::new();
    };
    let exits: Vec<Segment> = network.exits().iter().map(|exit| placed(exit, memory)).collect();
    let own: Vec<Segment> =
        asr.exits.iter().filter_map(|id| network.exit(*id)).map(|exit| placed(exit, memory)).collect();
    for sight in &sights {
        // What lies behind an exit is another space; what was seen from there lies behind one of its
        // own (Fig. 3.15).
        let exits = sight.meets(if sight.from_within { &exits } else { &own });
        let through =
            |cell: DVec2| exits.iter().any(|exit| exit.crossing(Segment::new(sight.from, cell)).is_some());
        floor.fill(sight.corners(), |cell| through(cell) != sight.from_within);
    }
    for stand in stands {
        floor.fill_around(stand, STANDING_ROOM);
    }
    floor.contour().into_iter().map(|corner| asr_from_map * corner).collect()
}

/// A surface of the space as it was seen first, in the map.
struct Sight {
    from: DVec2,
    seen: Segment,
    /// Whether the robot was in the space itself.
    from_within: bool,
}

impl Sight {
    /// Those of the exits that a line of sight may cross.
    fn meets(&self, exits: &[Segment]) -> Vec<Segment> {
        let [a, b, c] = self.corners();
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let apart =
            |exit: &Segment| exit.a.max(exit.b).cmplt(low).any() || exit.a.min(exit.b).cmpgt(high).any();
        exits.iter().copied().filter(|exit| !apart(exit)).collect()
    }

    fn corners(&self) -> [DVec2; 3] {
        [self.from, self.seen.a, self.seen.b]
    }
}

fn sights(asr: &Asr, network: &Network, memory: &Memory) -> Vec<Sight> {
    let mfis = memory.mfis();
    let own = mfis.remembered().filter(|surface| network.asr_of(surface.id) == Some(asr.id));
    let sight = |surface: &StoredSurface| {
        let point = memory.path().get(surface.step)?;
        let from_within = network.asr_at(surface.step) == Some(asr.id);
        Some(Sight { from: mfis.place_of(point).position, seen: mfis.in_map(surface), from_within })
    };
    own.filter_map(sight).collect()
}

/// Where an exit lies in the map.
fn placed(exit: &Exit, memory: &Memory) -> Segment {
    memory.mfis().map_from_frame(exit.frame) * exit.segment
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::{Pose, trig};

    use super::*;
    use crate::{
        Mapper, MapperSetup,
        perception::{Moment, Reading, Scan},
    };

    /// A robot in the middle of the western wall of a room of 4 m by 3 m, looking east.
    fn mapper() -> Mapper {
        let beam = |number: i32| {
            let (sin, cos) = trig::sin_cos(f64::from(number - 90).to_radians());
            (1.5 / sin.abs().max(1e-9)).min(4.0 / cos.max(1e-9))
        };
        let scan = Scan {
            robot_from_laser: Pose::IDENTITY,
            angle_min: -trig::FRAC_PI_2,
            angle_increment: 1_f64.to_radians(),
            range_max: 8.0,
            ranges: (0..181).map(beam).collect(),
            labels: Vec::new(),
        };
        let mut mapper = Mapper::new(&MapperSetup::named("perceptual").unwrap(), 1);
        let reading = Reading { t: 0.0, odom_from_robot: Pose::IDENTITY, moment: Moment::StepEnd, scan };
        assert_eq!(mapper.observe(&reading).unwrap().placed.len(), 3);
        mapper
    }

    fn area(outline: &[DVec2]) -> f64 {
        let next = outline.iter().cycle().skip(1);
        outline.iter().zip(next).map(|(a, b)| 0.5 * a.perp_dot(*b)).sum()
    }

    #[test]
    fn the_outline_holds_what_was_seen_and_no_more() {
        let mapper = mapper();
        let network = mapper.network().unwrap();
        let corners = outline(&network.asrs()[0], network, mapper.memory());
        let area = area(&corners);
        assert!((11.0..14.0).contains(&area), "{area} of 12 square metres, {corners:?}");
        assert!(corners.len() < 20, "{corners:?}");
        let room = |point: &DVec2| (-0.7..=4.3).contains(&point.x) && point.y.abs() <= 1.8;
        assert!(corners.iter().all(room), "{corners:?}");
    }

    #[test]
    fn a_space_of_which_nothing_is_known_has_no_outline() {
        let network = Network::default();
        assert!(outline(&network.asrs()[0], &network, &Memory::default()).is_empty());
    }
}
