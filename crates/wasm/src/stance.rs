use cogmap_geometry::{DVec2, Pose, trig::FRAC_PI_2};
use cogmap_mapping::Mapper;
use cogmap_simulation::Session;
use serde::{Deserialize, Serialize};
use tsify::Tsify;

/// From where a memory is looked at: the question that the thesis begins with (chapter 1, §2.2.2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum Stance {
    /// From outside (allocentric): the map stands still and the robot moves in it.
    #[default]
    Map,
    /// From the robot (egocentric): it stands still, looking up, and what it remembers moves around it.
    Robot,
    /// From the entrance of the local space that the robot is in: into the space is up.
    Entrance,
}

impl Stance {
    /// What turns a mapper's map so that it is seen from there, around a point; `None` from outside, and where
    /// the mapper knows no such place.
    pub(crate) fn view_from_map(self, session: &Session, mapper: usize, middle: DVec2) -> Option<Pose> {
        let mapper = session.mappers().get(mapper)?;
        let map_from_here = match self {
            Self::Map => return None,
            Self::Robot => mapper.map_from_robot(session.odom_from_robot())?,
            Self::Entrance => map_from_entrance(mapper)?,
        };
        let up = Pose { position: middle, heading: FRAC_PI_2 };
        Some(up * map_from_here.inverse())
    }
}

fn map_from_entrance(mapper: &Mapper) -> Option<Pose> {
    let network = mapper.network()?;
    let asr = network.asr(network.current())?;
    Some(mapper.mfis().map_from_frame(asr.frame) * asr.frame_from_entrance)
}

#[cfg(test)]
mod tests {
    use super::*;
    use cogmap_mapping::MapperSetup;
    use cogmap_simulation::{Command, Robot, SessionRecord, Source};

    fn under_way() -> Session {
        let world = cogmap_formats::world::read(
            r#"{"format": "cogmap-world/1", "name": "Cell", "walls": [[[0,0],[5,0],[5,4],[0,4],[0,0]]],
                "start": {"position": [1,2]}}"#,
            "cell.world.json",
        );
        let source = Source::world(world.unwrap(), Robot::named("good").unwrap());
        let mappers = vec![MapperSetup::named("perceptual").unwrap()];
        let mut session = Session::drive(SessionRecord::new(source, mappers, 1)).unwrap();
        session.command(Command::Step { turn: 0.5, travel: 1.0 });
        while session.advance() && !session.at_rest() {}
        session
    }

    #[test]
    fn whoever_looks_stands_in_the_middle_and_looks_up() {
        let (session, middle) = (under_way(), DVec2::new(3.0, -1.0));
        let mapper = &session.mappers()[0];
        let robot = mapper.map_from_robot(session.odom_from_robot()).unwrap();
        let start = mapper.path()[0].frame_from_robot;
        for (stance, looker) in [(Stance::Robot, robot), (Stance::Entrance, start)] {
            let view = stance.view_from_map(&session, 0, middle).unwrap();
            assert!((view * looker.position).distance(middle) < 1e-9, "{stance:?}");
            let ahead = view * (looker * DVec2::X) - middle;
            assert!(ahead.distance(DVec2::Y) < 1e-9, "{stance:?}: {ahead}");
        }
        assert!(robot.position.distance(start.position) > 0.5);
        assert_eq!(Stance::Map.view_from_map(&session, 0, middle), None);
    }
}
