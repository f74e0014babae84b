//! What a memory holds, for a page that says it in words: where the robot is, places, exits and surfaces.

use cogmap_geometry::{DVec2, Metric, Pose, normalize_angle, trig};
use cogmap_mapping::{
    memory::{Mfis, SurfaceId},
    places::{Asr, Network},
};
use cogmap_scene::{Thing, believed_home, segment_of, things_like};
use cogmap_simulation::Session;
use serde::Serialize;
use tsify::Tsify;

use crate::{
    schematic::floor_area,
    story::{Occasion, Teller},
};

/// What a mapper has in mind at this moment.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct Contents {
    /// The mapper.
    pub mapper: String,
    /// Its latest view.
    pub view: Occasion,
    /// How many surfaces it remembers.
    pub surfaces: usize,
    /// Where it believes the robot to be.
    pub robot: Whereabouts,
    /// Its local spaces, the one with the robot first, then by number; all in one where it does not know
    /// what a space is.
    pub places: Vec<Place>,
    /// The exits that were only seen, nearest first.
    pub supposed: Vec<SupposedExit>,
}

/// Where a robot believes to be.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct Whereabouts {
    /// The local space that it is in.
    pub asr: Option<u32>,
    /// How home lies: where the run began. Nothing where the robot does not know.
    pub home: Option<Bearing>,
    /// How much it has turned against how it stood there, degrees, left positive, at most half a turn.
    pub turned_deg: f64,
}

/// How something lies seen from the robot: its nearest point.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct Bearing {
    /// Metres.
    pub distance: f64,
    /// Degrees from straight ahead, left positive.
    pub angle_deg: f64,
}

/// A local space.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct Place {
    /// Its number; nothing where the mapper does not know what a space is.
    pub asr: Option<u32>,
    /// Whether the robot believes to be in it.
    pub current: bool,
    /// The area of its floor as far as it was seen, square metres.
    pub area: f64,
    /// The view in which it was opened.
    pub opened: Occasion,
    /// Its exits, in the order of finding.
    pub exits: Vec<WayOut>,
    /// How many surfaces belong to it.
    pub surfaces: usize,
    /// Some of them, nearest to the robot first.
    pub nearest: Vec<NearSurface>,
}

/// An exit of a local space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct WayOut {
    /// Its number.
    pub exit: u32,
    /// The space behind it.
    pub to: u32,
    /// From jamb to jamb, metres.
    pub width: f64,
    /// How it lies seen from the robot.
    pub lies: Bearing,
    /// The view in which it was found.
    pub made: Occasion,
}

/// A surface.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct NearSurface {
    /// Its number.
    pub surface: u32,
    /// Metres.
    pub length: f64,
    /// How it lies seen from the robot.
    pub lies: Bearing,
    /// The view that saw it first.
    pub seen: Occasion,
}

/// An exit that was only seen.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct SupposedExit {
    /// Its number.
    pub number: u32,
    /// From jamb to jamb, metres.
    pub width: f64,
    /// How it lies seen from the robot.
    pub lies: Bearing,
    /// The view that saw it first.
    pub seen: Occasion,
}

/// What a mapper has in mind, with at most so many surfaces of each space; nothing before its first view.
pub(crate) fn contents(
    session: &Session,
    mapper: usize,
    most: usize,
    position_at: &dyn Fn(f64) -> u64,
) -> Option<Contents> {
    let teller = Teller::of(session, mapper, position_at)?;
    let robot = teller.mind.map_from_robot(session.odom_from_robot())?;
    let writer = Writer { teller, robot, most };
    Some(Contents {
        mapper: session.record().mappers.get(mapper)?.name().to_owned(),
        view: writer.latest(),
        surfaces: writer.mfis().remembered().count(),
        robot: writer.whereabouts()?,
        places: writer.places(),
        supposed: writer.supposed(),
    })
}

struct Writer<'a> {
    teller: Teller<'a>,
    robot: Pose,
    most: usize,
}

impl Writer<'_> {
    fn mfis(&self) -> &Mfis {
        self.teller.mind.mfis()
    }

    fn latest(&self) -> Occasion {
        self.teller.occasion(self.teller.mind.path().len().saturating_sub(1))
    }

    fn whereabouts(&self) -> Option<Whereabouts> {
        let mind = self.teller.mind;
        let begun = mind.mfis().place_of(mind.path().first()?);
        Some(Whereabouts {
            asr: mind.network().map(|network| network.current().0),
            home: believed_home(mind).map(|home| self.bearing(home)),
            turned_deg: normalize_angle(self.robot.heading - begun.heading).to_degrees(),
        })
    }

    fn bearing(&self, at: DVec2) -> Bearing {
        let there = self.robot.inverse() * at;
        Bearing { distance: there.norm(), angle_deg: trig::atan2(there.y, there.x).to_degrees() }
    }

    /// How the nearest point of a thing lies.
    fn lies(&self, thing: Thing) -> Option<Bearing> {
        let segment = segment_of(self.teller.mind, thing)?;
        Some(self.bearing(segment.closest_point(self.robot.position)))
    }

    fn places(&self) -> Vec<Place> {
        let Some(network) = self.teller.mind.network() else {
            let all: Vec<SurfaceId> = self.mfis().remembered().map(|stored| stored.id).collect();
            let (opened, surfaces) = (self.teller.occasion(0), all.len());
            let nearest = self.nearest(&all);
            return vec![Place {
                asr: None,
                current: true,
                area: 0.0,
                opened,
                exits: Vec::new(),
                surfaces,
                nearest,
            }];
        };
        let mut places: Vec<Place> = network.asrs().iter().map(|asr| self.place(asr, network)).collect();
        places.sort_by_key(|place| !place.current);
        places
    }

    fn place(&self, asr: &Asr, network: &Network) -> Place {
        let own: Vec<SurfaceId> =
            network.surfaces_of(asr.id).iter().copied().filter(|id| self.mfis().remembers(*id)).collect();
        Place {
            asr: Some(asr.id.0),
            current: network.current() == asr.id,
            area: floor_area(asr, network, self.teller.mind),
            opened: self.teller.occasion(asr.step),
            exits: self.exits(asr, network),
            surfaces: own.len(),
            nearest: self.nearest(&own),
        }
    }

    fn exits(&self, asr: &Asr, network: &Network) -> Vec<WayOut> {
        let way = |id: &_| {
            let exit = network.exit(*id)?;
            Some(WayOut {
                exit: exit.id.0,
                to: exit.leads_from(asr.id)?.0,
                width: exit.segment.length(),
                lies: self.lies(Thing::Exit(exit.id))?,
                made: self.teller.occasion(exit.step),
            })
        };
        asr.exits.iter().filter_map(way).collect()
    }

    fn nearest(&self, ids: &[SurfaceId]) -> Vec<NearSurface> {
        let here = self.robot.position;
        let away = |id: &SurfaceId| Some((self.mfis().in_map(self.mfis().get(*id)?).distance_to(here), *id));
        let mut all: Vec<(f64, SurfaceId)> = ids.iter().filter_map(away).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        all.truncate(self.most);
        all.into_iter().filter_map(|(_, id)| self.surface(id)).collect()
    }

    fn surface(&self, id: SurfaceId) -> Option<NearSurface> {
        let stored = self.mfis().get(id)?;
        Some(NearSurface {
            surface: id.0,
            length: stored.segment.length(),
            lies: self.lies(Thing::Surface(id))?,
            seen: self.teller.occasion(stored.step),
        })
    }

    fn supposed(&self) -> Vec<SupposedExit> {
        let hypotheses = self.teller.mind.network().map_or(&[][..], Network::hypotheses);
        let supposed = |thing| {
            let Thing::Supposed(number) = thing else { return None };
            let hypothesis = hypotheses.get(number)?;
            let seen = self.teller.occasion(hypothesis.step);
            let number = u32::try_from(number).ok()?;
            Some(SupposedExit { number, width: hypothesis.segment.length(), lies: self.lies(thing)?, seen })
        };
        let all = things_like(self.teller.mind, Thing::Supposed(0)).into_iter();
        let mut supposed: Vec<SupposedExit> = all.filter_map(supposed).collect();
        supposed.sort_by(|a, b| a.lies.distance.total_cmp(&b.lies.distance));
        supposed
    }
}

#[cfg(test)]
mod tests {
    use crate::two_rooms::two_rooms;

    #[test]
    fn everything_in_mind_is_in_one_of_the_places_the_robots_own_first() {
        let run = two_rooms();
        let contents = run.contents(0, usize::MAX).unwrap();
        assert_eq!(contents.places.iter().map(|place| place.asr).collect::<Vec<_>>(), [Some(1), Some(0)]);
        assert_eq!(contents.places.iter().map(|place| place.nearest.len()).sum::<usize>(), contents.surfaces);
        assert_eq!((contents.robot.asr, contents.places[0].current), (Some(1), true));
        let [ahead, back] = [&contents.places[0].exits, &contents.places[1].exits];
        assert_eq!((ahead[0].to, back[0].to, ahead[0].exit), (0, 1, back[0].exit));
        // The robot has driven 7.5 m straight on, through the door 4 m ahead: both lie behind it.
        let home = contents.robot.home.unwrap();
        assert!((home.distance - 7.5).abs() < 0.5 && home.angle_deg.abs() > 150.0, "{home:?}");
        assert!((2.5..4.5).contains(&ahead[0].lies.distance) && ahead[0].lies.angle_deg.abs() > 150.0);
    }

    #[test]
    fn of_many_surfaces_the_nearest_are_told_and_the_rest_counted() {
        let run = two_rooms();
        let contents = run.contents(0, 2).unwrap();
        for place in &contents.places {
            let [one, other] = place.nearest[..] else { panic!("{place:?}") };
            assert!(one.lies.distance <= other.lies.distance && place.surfaces > 2);
            assert!(one.seen.step <= contents.view.step && one.seen.t <= contents.view.t);
        }
    }

    #[test]
    fn who_knows_no_spaces_has_all_surfaces_in_one_list() {
        let run = two_rooms();
        let contents = run.contents(1, 5).unwrap();
        let [all] = &contents.places[..] else { panic!("{:?}", contents.places) };
        assert_eq!((all.asr, all.surfaces, all.nearest.len()), (None, contents.surfaces, 5));
        assert!(contents.supposed.is_empty() && contents.robot.asr.is_none());
        assert_eq!(run.contents(7, 5), None);
    }
}
