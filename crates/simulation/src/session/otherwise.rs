use crate::{Session, Source, TimedCommand};

impl Session {
    /// Goes over to another course of the same run, as from its record: back to the moment at which the two
    /// part, no further, and from there with the other commands. `false` where it is not the same world,
    /// robot or log.
    pub fn go_over_to(&mut self, other: &Source) -> bool {
        let Some(parting) = self.record.source.parts_from(other) else { return false };
        if self.position() > parting {
            self.jump(parting);
        }
        self.checkpoints.forget_after(parting);
        self.record.source = other.clone();
        true
    }
}

impl Source {
    /// The tick at whose beginning two courses of the same run part; `None` where they are no such courses.
    #[must_use]
    pub fn parts_from(&self, other: &Self) -> Option<u64> {
        let (
            Self::World { world, robot, commands, ticks },
            Self::World { world: same, robot: alike, commands: others, ticks: until },
        ) = (self, other)
        else {
            return None;
        };
        let differ =
            |(one, two): (&TimedCommand, &TimedCommand)| (one != two).then(|| one.tick.min(two.tick));
        let first = commands.iter().zip(others).find_map(differ);
        let shared = commands.len().min(others.len());
        let beyond = commands.get(shared).or(others.get(shared)).map(|timed| timed.tick);
        let end = *ticks.min(until);
        (world == same && robot == alike).then(|| first.or(beyond).map_or(end, |tick| tick.min(end)))
    }
}

#[cfg(test)]
mod tests {
    use cogmap_mapping::MapperSetup;

    use crate::{Command, Robot, Session, SessionRecord, Source, World};

    fn session() -> Session {
        let world: World = serde_json::from_str(
            r#"{"format": "cogmap-world/1", "name": "Cell", "start": {"position": [1, 2]},
                "walls": [[[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]]]}"#,
        )
        .unwrap();
        let source = Source::world(world, Robot::named("bad").unwrap());
        let mappers = vec![MapperSetup::named("perceptual").unwrap()];
        Session::drive(SessionRecord::new(source, mappers, 3)).unwrap()
    }

    fn drive(session: &mut Session, turn: f64) {
        session.command(Command::Step { turn, travel: 0.6 });
        while session.advance() && !session.at_rest() {}
    }

    #[test]
    fn the_old_course_comes_back_to_the_last_bit_and_so_does_the_new_one() {
        let mut session = session();
        [0.1, 0.2, -0.3].into_iter().for_each(|turn| drive(&mut session, turn));
        let (old, end) = (session.record().source.clone(), session.end());
        let before = session.journal().mappers[0].reports.clone();
        session.jump(end / 2);
        drive(&mut session, 0.7);
        let (new, new_end) = (session.record().source.clone(), session.end());
        let after = session.journal().mappers[0].reports.clone();
        assert_ne!(before, after);
        assert_eq!(old.parts_from(&new), Some(end / 2));
        for (course, until, reports) in [(&old, end, &before), (&new, new_end, &after)] {
            assert!(session.go_over_to(course));
            assert_eq!(session.position(), end / 2);
            session.jump(until);
            assert_eq!(&session.journal().mappers[0].reports, reports);
        }
    }

    #[test]
    fn another_building_is_no_course_of_this_run() {
        let mut session = session();
        let mut other = session.record().source.clone();
        if let Source::World { world, .. } = &mut other {
            world.walls.clear();
        }
        assert!(!session.go_over_to(&other));
    }
}
