//! Ways home in small worlds with the bad robot and every strategy: driven natively, in Node and in a
//! browser, they must lead through the same decisions to the same spot and the same map.

use cogmap_formats::{run, sha256_hex, world};
use cogmap_geometry::DVec2;
use cogmap_mapping::{MapperSetup, Sentence};
use cogmap_navigation::Decision;
use cogmap_simulation::{Command, Driver, Robot, Session, SessionRecord, Source, Strategy};

/// The worlds: their names and files.
pub(crate) const WORLDS: [(&str, &str); 2] = [
    ("around-a-corner", include_str!("../../../worlds/around-a-corner.world.json")),
    ("small-office", include_str!("../../../worlds/small-office.world.json")),
];

/// A line a strategy: the world, the strategy, the SHA-256 of what the robot decided (not of its words),
/// where it ended and its map.
pub(crate) fn digests(name: &str, file: &str) -> String {
    let mut session = driven(name, file);
    let out = session.position();
    let line = |strategy: &str| {
        session.jump(out);
        session.command(Command::GoHome { strategy: Strategy::named(strategy).unwrap() });
        while session.advance() && !session.at_rest() {}
        let wordless = |decision: &Decision| Decision {
            why: Sentence::default(),
            events: Vec::new(),
            ..decision.clone()
        };
        let decisions: Vec<Decision> = session.journal().decisions.iter().map(wordless).collect();
        assert!(decisions.len() > 5, "{name}, {strategy}: there is something to compare");
        let pose = session.world_from_robot();
        let said = format!("{decisions:?} {pose:?} {}", run::map(&session, 0));
        format!("{name} {strategy} {}\n", sha256_hex(said.as_bytes()))
    };
    Strategy::names().into_iter().map(line).collect()
}

/// The robot at the end of the world's first route.
fn driven(name: &str, file: &str) -> Session {
    let (world, robot) = (world::read(file, name).unwrap(), Robot::named("bad").unwrap());
    let (_, route) = world.routes.first_key_value().unwrap();
    let route: Vec<DVec2> = route.iter().map(|&point| point.into()).collect();
    let mut driver = Driver::new(&world, &robot, &route).unwrap();
    let mapper = MapperSetup::named("consensus").unwrap();
    let mut session =
        Session::drive(SessionRecord::new(Source::world(world, robot), vec![mapper], 7)).unwrap();
    driver.drive(&mut session);
    session
}
