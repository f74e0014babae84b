use cogmap_geometry::DVec2;
use cogmap_mapping::MapperSetup;
use cogmap_simulation::{
    Building, Command, Driver, Episode, Robot, Session, SessionRecord, Setting, Source, Strategy,
};

/// The building, the way out and all chance.
const SEED: u64 = 6;
/// So many moments of the way home are kept, at most.
const KEPT: usize = 100;
/// A way home takes no more ticks than this.
pub(crate) const TICKS: u64 = 50_000;

/// Moments of a way home, each a tick before a decision.
pub(crate) struct WayHome {
    before: Vec<Session>,
    now: Vec<Session>,
}

impl WayHome {
    /// The moments before decisions in a generated building in the setting of that name, evenly spread over the
    /// way; `None` where the building has no place for that setting.
    pub(crate) fn in_setting(setting: &str) -> Option<Self> {
        let world = Building::generate(SEED);
        let route: Vec<DVec2> = world.routes.values().next()?.iter().map(|&point| point.into()).collect();
        let episode = Episode::new(&world, &route, Setting::named(setting)?, SEED)?;
        let mut session = at_the_command(&episode)?;
        let begin = session.position();
        let mut moments = Vec::new();
        loop {
            let decided = session.journal().decisions.len();
            session.advance();
            if session.journal().decisions.len() > decided {
                moments.push(session.position() - 1);
            }
            if session.at_rest() || session.position() > begin + TICKS {
                break;
            }
        }
        let apart = moments.len().div_ceil(KEPT).max(1);
        session.jump(begin);
        let mut before = Vec::new();
        for &moment in moments.iter().step_by(apart) {
            while session.position() < moment {
                session.advance();
            }
            before.push(session.forked());
        }
        Some(Self { before, now: Vec::new() })
    }

    pub(crate) fn decisions(&self) -> usize {
        self.before.len()
    }

    pub(crate) fn rewind(&mut self) {
        self.now = self.before.iter().map(Session::forked).collect();
    }

    /// Lets the robot decide at each moment; what it decided, to compare platforms bit for bit.
    pub(crate) fn run(&mut self) -> f64 {
        let mut sum = 0.0;
        for session in &mut self.now {
            session.advance();
            let way = session.journal().decisions.last().into_iter().flat_map(|decision| &decision.way);
            sum += way.map(|at| at.x + at.y).sum::<f64>();
        }
        sum
    }
}

/// The bad robot at the end of its way out, told to go home.
pub(crate) fn at_the_command(episode: &Episode) -> Option<Session> {
    let robot = Robot::named("bad")?;
    let mut driver = Driver::new(&episode.world, &robot, &episode.route).ok()?;
    let mappers = vec![MapperSetup::named("consensus")?];
    let source = Source::world(episode.world.clone(), robot);
    let mut session = Session::drive(SessionRecord::new(source, mappers, SEED)).ok()?;
    driver.drive(&mut session);
    for change in &episode.changes {
        session.command(Command::Change(change.clone()));
        session.advance();
    }
    session.command(Command::GoHome { strategy: Strategy::named("recommended")? });
    Some(session)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_home_can_be_decided_again_and_again_with_the_same_outcome() {
        let mut way = WayHome::in_setting("furnished").unwrap();
        assert!(way.decisions() > 10, "{}", way.decisions());
        way.rewind();
        let first = way.run();
        way.rewind();
        assert!(first != 0.0 && way.run().to_bits() == first.to_bits());
    }
}
