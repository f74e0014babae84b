//! A drive along a world's first route and home again, and what became of it in truth.

use std::fs;

use cogmap_formats::world;
use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_mapping::MapperSetup;
use cogmap_navigation::{Act, Decision, FaithfulParams, HomingEvent, Mode, StrategySetup};
use cogmap_simulation::{Command, Driver, Robot, Session, SessionRecord, Source, Strategy};

/// The robot decided, and where it was in truth.
pub(super) struct Moment {
    pub(super) decision: Decision,
    pub(super) world_from_robot: Pose,
    world_from_place: Pose,
}

impl Moment {
    /// The way that the robot had in mind, as it lies in the world.
    pub(super) fn way(&self) -> Vec<DVec2> {
        self.decision.way.iter().map(|&point| self.world_from_place * point).collect()
    }

    pub(super) fn here(&self) -> DVec2 {
        self.world_from_robot.position
    }

    pub(super) fn told(&self, wanted: fn(&HomingEvent) -> bool) -> bool {
        self.decision.events.iter().any(wanted)
    }
}

/// A way home.
pub(super) struct Trip {
    pub(super) moments: Vec<Moment>,
    /// Where the robot was in truth at each tick of the way home.
    pub(super) track: Vec<DVec2>,
    pub(super) way_out: f64,
    pub(super) way_home: f64,
    /// The shortest way home in truth, metres.
    pub(super) shortest: f64,
    /// Metres from home in truth, at the end.
    pub(super) distance: f64,
    pub(super) walls: Vec<Segment>,
    home: DVec2,
    pub(super) collisions: usize,
}

/// The bad robot follows a world's first route and goes home to the letter, with some parameters changed.
pub(super) fn trip(world: &str, mapper: &str, seed: u64, change: fn(&mut FaithfulParams)) -> Trip {
    let mut params = FaithfulParams::default();
    change(&mut params);
    go(world, mapper, seed, Strategy::Robot(StrategySetup::Faithful(params)))
}

/// The same with any strategy.
pub(super) fn go(name: &str, mapper: &str, seed: u64, strategy: Strategy) -> Trip {
    let file = format!("{}/../worlds/{name}.world.json", env!("CARGO_MANIFEST_DIR"));
    let world = world::read(&fs::read_to_string(&file).unwrap(), &file).unwrap();
    let robot = Robot::named("bad").unwrap();
    let route: Vec<DVec2> = world.routes.values().next().unwrap().iter().map(|&at| at.into()).collect();
    let mut driver = Driver::new(&world, &robot, &route).unwrap();
    let mappers = vec![MapperSetup::named(mapper).unwrap()];
    let mut session = Session::drive(SessionRecord::new(Source::world(world, robot), mappers, seed)).unwrap();
    driver.drive(&mut session);
    session.command(Command::GoHome { strategy });
    let (mut moments, mut track) = (Vec::new(), Vec::new());
    loop {
        session.advance();
        track.push(session.world_from_robot().unwrap().position);
        if let Some(decision) = session.journal().decisions.get(moments.len()) {
            moments.push(moment(&session, decision));
            if matches!(decision.act, Act::Arrived | Act::Stuck) {
                break;
            }
        }
    }
    let way = session.way_home().unwrap();
    Trip {
        way_out: way.way_out,
        way_home: way.way_home,
        shortest: way.shortest.unwrap(),
        distance: way.distance,
        walls: session.solids().unwrap().segments.clone(),
        home: session.journal().truth[0].pose.position,
        collisions: session.journal().mappers[0].collisions().count(),
        moments,
        track,
    }
}

fn moment(session: &Session, decision: &Decision) -> Moment {
    let (mapper, world_from_robot) = (&session.mappers()[0], session.world_from_robot().unwrap());
    let map_from_robot = mapper.map_from_robot(session.odom_from_robot()).unwrap();
    let map_from_place = mapper.mfis().map_from_frame(decision.frame);
    let world_from_place = world_from_robot * map_from_robot.inverse() * map_from_place;
    Moment { decision: decision.clone(), world_from_robot, world_from_place }
}

impl Trip {
    /// Whether the robot stopped by itself within so many metres of home.
    pub(super) fn home_within(&self, metres: f64) -> bool {
        self.moments.last().is_some_and(|last| last.decision.act == Act::Arrived) && self.distance <= metres
    }

    /// Decisions that the remembered route led.
    pub(super) fn route_steps(&self) -> impl Iterator<Item = &Moment> {
        self.moments.iter().filter(|moment| moment.decision.mode == Mode::Route)
    }

    /// Whether a way goes through a wall, in truth.
    pub(super) fn blocked(&self, way: &[DVec2]) -> bool {
        let legs = way.windows(2).map(|ends| Segment::new(ends[0], ends[1]));
        legs.into_iter().any(|leg| self.walls.iter().any(|wall| wall.crossing(leg).is_some()))
    }

    /// How often the robot crossed a line from its right to its left.
    pub(super) fn crossings(&self, a: [f64; 2], b: [f64; 2]) -> usize {
        let line = Segment::new(a.into(), b.into());
        let crosses = |ends: &[DVec2]| {
            let step = Segment::new(ends[0], ends[1]);
            line.crossing(step).is_some() && line.offset_of(ends[1]).is_some_and(|offset| offset > 0.0)
        };
        self.track.windows(2).filter(|ends| ends[0] != ends[1] && crosses(ends)).count()
    }

    /// How much the robot turned in all, radians.
    pub(super) fn turned(&self) -> f64 {
        let turn = |moment: &Moment| match moment.decision.act {
            Act::Step { turn, .. } => turn.abs(),
            Act::Arrived | Act::Stuck => 0.0,
        };
        self.moments.iter().map(turn).sum()
    }

    /// Metres between home and where the robot believes it to be when it is told to go there.
    pub(super) fn home_offset(&self) -> f64 {
        let first = &self.moments[0];
        (first.world_from_place * first.decision.home.unwrap()).distance(self.home)
    }
}
