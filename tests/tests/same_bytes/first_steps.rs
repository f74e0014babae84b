//! The first steps of a route through every designed world, with the bad robot and every mapper:
//! driven natively, in Node and in a browser, they must give the same maps.

use cogmap_formats::{run, sha256_hex, world};
use cogmap_geometry::DVec2;
use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Driver, Robot, Session, SessionRecord, Source};

/// How many steps are driven; a drive of the whole routes would take minutes in a browser.
const STEPS: usize = 40;

/// Every designed world: its name and its file.
pub(crate) const WORLDS: [(&str, &str); 14] = [
    ("around-a-corner", include_str!("../../../worlds/around-a-corner.world.json")),
    ("box-course", include_str!("../../../worlds/box-course.world.json")),
    ("environment-a", include_str!("../../../worlds/environment-a.world.json")),
    ("environment-b", include_str!("../../../worlds/environment-b.world.json")),
    ("long-corridor", include_str!("../../../worlds/long-corridor.world.json")),
    ("long-office", include_str!("../../../worlds/long-office.world.json")),
    ("narrow-passage", include_str!("../../../worlds/narrow-passage.world.json")),
    ("no-passage", include_str!("../../../worlds/no-passage.world.json")),
    ("office", include_str!("../../../worlds/office.world.json")),
    ("shortcut", include_str!("../../../worlds/shortcut.world.json")),
    ("small-office", include_str!("../../../worlds/small-office.world.json")),
    ("tour", include_str!("../../../worlds/tour.world.json")),
    ("two-shortcuts", include_str!("../../../worlds/two-shortcuts.world.json")),
    ("u-trap", include_str!("../../../worlds/u-trap.world.json")),
];

/// A line a mapper: the world, the mapper, the SHA-256 of its map.
pub(crate) fn digests(name: &str, file: &str) -> String {
    let session = drive(name, file);
    let line = |(mapper, of): (usize, &str)| {
        format!("{name} {of} {}\n", sha256_hex(run::map(&session, mapper).as_bytes()))
    };
    MapperSetup::NAMES.into_iter().enumerate().map(line).collect()
}

fn drive(name: &str, file: &str) -> Session {
    let (world, robot) = (world::read(file, name).unwrap(), Robot::named("bad").unwrap());
    let (_, route) = world.routes.first_key_value().unwrap();
    let route: Vec<DVec2> = route.iter().map(|&point| point.into()).collect();
    let mut driver = Driver::new(&world, &robot, &route).unwrap();
    let mappers = MapperSetup::NAMES.iter().filter_map(|name| MapperSetup::named(name)).collect();
    let mut session = Session::drive(SessionRecord::new(Source::world(world, robot), mappers, 7)).unwrap();
    for _ in 0..STEPS {
        let Some(command) = session.world_from_robot().and_then(|pose| driver.next_command(pose)) else {
            break;
        };
        session.command(command);
        while session.advance() && !session.at_rest() {}
    }
    session
}
