use std::{collections::BTreeMap, rc::Rc};

use cogmap_geometry::{DVec2, Pose};
use cogmap_mapping::{Mapper, MapperSetup, StepReport, memory::ConsensusParams};
use cogmap_navigation::{Act, Decision, FaithfulParams, StrategySetup};
use cogmap_simulation::{
    Command, Driver, MapperJournal, Robot, Session, SessionRecord, Source, Strategy, World,
};

use crate::worlds;

/// A drive that figures are drawn from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Outing {
    /// What it is called in a figure.
    pub(super) place: &'static str,
    /// Where it leads through.
    pub(super) building: Building,
    /// The route's name.
    pub(super) route: &'static str,
    /// The robot's name.
    pub(super) robot: &'static str,
    /// The mappers' names.
    pub(super) mappers: &'static [&'static str],
}

/// Where a world comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Building {
    /// One of the worlds that belong to the program.
    Named(&'static str),
    /// The content of a world file made for a figure.
    Made(&'static str),
}

/// The drives that figures are drawn from, each made once however many figures show it.
pub struct Runs {
    seed: u64,
    driven: BTreeMap<Outing, Rc<Run>>,
}

/// A drive that is over.
pub(super) struct Run {
    pub(super) session: Session,
    outing: Outing,
}

impl Runs {
    /// No drives yet; everything random in them will come from `seed`.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self { seed, driven: BTreeMap::new() }
    }

    /// What everything random comes from.
    pub(super) fn seed(&self) -> u64 {
        self.seed
    }

    /// The drive, to the end of its route.
    pub(super) fn of(&mut self, outing: &Outing) -> Result<Rc<Run>, String> {
        if let Some(run) = self.driven.get(outing) {
            return Ok(Rc::clone(run));
        }
        let run = Rc::new(self.until(outing, |_| false)?);
        self.driven.insert(*outing, Rc::clone(&run));
        Ok(run)
    }

    /// The drive to the first rest at which `enough` says so, or to its end.
    pub(super) fn until(&self, outing: &Outing, enough: impl Fn(&Session) -> bool) -> Result<Run, String> {
        let world = outing.building.world()?;
        let robot =
            Robot::named(outing.robot).ok_or_else(|| format!("no robot is called {}", outing.robot))?;
        let route = world.routes.get(outing.route).cloned().unwrap_or_default();
        let route: Vec<DVec2> = route.into_iter().map(DVec2::from).collect();
        let mut driver = Driver::new(&world, &robot, &route)?;
        let mappers = outing.mappers.iter().filter_map(|name| setup(name)).collect();
        let record = SessionRecord::new(Source::world(world, robot), mappers, self.seed);
        let mut session = begin(record)?;
        while let Some(command) = session.world_from_robot().and_then(|pose| driver.next_command(pose)) {
            if enough(&session) {
                break;
            }
            session.command(command);
            while session.advance() && !session.at_rest() {}
        }
        Ok(Run { session, outing: *outing })
    }
}

/// Our mapper as it is where figures are about the shape of the map: a recognised place would hide how far
/// the map has drifted.
pub(super) const UNAIDED: &str = "consensus without recognition";

fn setup(name: &str) -> Option<MapperSetup> {
    if name != UNAIDED {
        return MapperSetup::named(name);
    }
    let mut params = ConsensusParams::default();
    params.recognition.on = false;
    Some(MapperSetup::Consensus(Box::new(params)))
}

impl Building {
    /// The world itself.
    pub(super) fn world(self) -> Result<World, String> {
        match self {
            Self::Named(name) => Ok(worlds::world(name)?.as_ref().clone()),
            Self::Made(text) => cogmap_formats::world::read(text, "a world made for a figure")
                .map_err(|error| error.to_string()),
        }
    }
}

/// A robot at the start of its world.
pub(super) fn begin(record: SessionRecord) -> Result<Session, String> {
    Session::drive(record).map_err(|problems| format!("the world has {} problems", problems.len()))
}

impl Run {
    /// The same robot on its way home to the letter (§3.3), up to the first decision at which `enough` says
    /// so, before that is carried out, or to its end.
    pub(super) fn homeward(
        &self,
        params: FaithfulParams,
        enough: impl Fn(&Session, &Decision) -> bool,
    ) -> Self {
        let mut session = self.session.forked();
        let strategy = Strategy::Robot(StrategySetup::Faithful(params));
        session.command(Command::GoHome { strategy });
        let mut seen = session.journal().decisions.len();
        while session.advance() && !session.at_rest() {
            let Some(decision) = session.journal().decisions.get(seen) else { continue };
            seen += 1;
            if matches!(decision.act, Act::Arrived | Act::Stuck) || enough(&session, decision) {
                break;
            }
        }
        Self { session, outing: self.outing }
    }

    /// The place in the record of the mapper of that name.
    pub(super) fn index(&self, mapper: &str) -> usize {
        self.outing.mappers.iter().position(|name| *name == mapper).unwrap_or(0)
    }

    /// What that mapper made of it.
    pub(super) fn mind(&self, mapper: &str) -> Result<(&Mapper, &MapperJournal), String> {
        let index = self.index(mapper);
        let (mappers, journals) = (self.session.mappers(), &self.session.journal().mappers);
        mappers.get(index).zip(journals.get(index)).ok_or_else(|| format!("no mapper is called {mapper}"))
    }

    /// What lies where in the world if the map is laid so that the first view was taken where it was.
    pub(super) fn world_from_map(&self) -> Pose {
        self.session.journal().truth.first().map_or(Pose::IDENTITY, |first| first.pose)
    }

    /// Where the robot truly was when it took a view.
    pub(super) fn truth_of(&self, report: &StepReport) -> Pose {
        let mut truth = self.session.journal().truth.iter();
        truth.find(|stamped| stamped.t >= report.t).map_or(Pose::IDENTITY, |stamped| stamped.pose)
    }

    /// Where odometry stood when the robot took a view.
    pub(super) fn odometry_of(&self, report: &StepReport) -> Pose {
        let mut odometry = self.session.journal().odometry.iter();
        odometry.find(|stamped| stamped.t >= report.t).map_or(Pose::IDENTITY, |stamped| stamped.pose)
    }

    /// Metres that the robot truly went.
    pub(super) fn length(&self) -> f64 {
        let truth = &self.session.journal().truth;
        truth.windows(2).map(|pair| pair[0].pose.position.distance(pair[1].pose.position)).sum()
    }

    /// What was run, for people.
    pub(super) fn words(&self) -> String {
        let seed = self.session.record().seed;
        format!("{}, {} robot, seed {seed}", self.outing.place, self.outing.robot)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::outings::{CORNER, SMALL_GOOD};

    #[test]
    fn a_drive_is_made_once_however_many_figures_show_it() {
        let mut runs = Runs::new(1);
        let (first, second) = (runs.of(&SMALL_GOOD).unwrap(), runs.of(&SMALL_GOOD).unwrap());
        assert!(Rc::ptr_eq(&first, &second));
        let goal = first.session.world_from_robot().unwrap().position;
        assert!(goal.distance(first.world_from_map().position) > 1.0 && first.length() > 5.0);
    }

    #[test]
    fn a_way_home_stops_where_enough_is_seen_or_at_its_end() {
        let out = Runs::new(1).of(&CORNER).unwrap();
        let decisions = |run: &Run| run.session.journal().decisions.len();
        let third =
            out.homeward(FaithfulParams::default(), |session, _| session.journal().decisions.len() == 3);
        assert!(decisions(&third) == 3 && third.session.homing().is_some());
        let home = out.homeward(FaithfulParams::default(), |_, _| false);
        assert_eq!(home.session.journal().decisions.last().unwrap().act, Act::Arrived);
        assert_eq!(decisions(&out), 0, "the drive itself goes on for others");
    }
}
