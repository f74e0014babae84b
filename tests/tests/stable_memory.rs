use std::fs;

use cogmap_formats::world;
use cogmap_mapping::{MapperSetup, memory::StoredSurface};
use cogmap_simulation::{Driver, Robot, Session, SessionRecord, Source};

/// A bad robot on the first route of a world, fed to every mapper at once.
fn drive(name: &str, mut each_reading: impl FnMut(&Session)) -> Session {
    let file = format!("{}/../worlds/{name}.world.json", env!("CARGO_MANIFEST_DIR"));
    let world = world::read(&fs::read_to_string(&file).unwrap(), &file).unwrap();
    let robot = Robot::named("bad").unwrap();
    let route: Vec<_> = world.routes.values().next().unwrap().iter().map(|&[x, y]| (x, y).into()).collect();
    let mut driver = Driver::new(&world, &robot, &route).unwrap();
    let mappers = MapperSetup::NAMES.iter().filter_map(|name| MapperSetup::named(name)).collect();
    let mut session = Session::drive(SessionRecord::new(Source::world(world, robot), mappers, 11)).unwrap();
    while let Some(command) = driver.next_command(session.world_from_robot().unwrap()) {
        session.command(command);
        while session.advance() && !session.at_rest() {
            each_reading(&session);
        }
        each_reading(&session);
    }
    session
}

#[test]
fn no_mapper_ever_changes_a_stored_surface() {
    for name in ["small-office", "office", "long-corridor"] {
        let mut before: Vec<Vec<StoredSurface>> = vec![Vec::new(); MapperSetup::NAMES.len()];
        drive(name, |session| {
            for (mapper, before) in session.mappers().iter().zip(&mut before) {
                let stored = mapper.mfis().surfaces();
                assert_eq!(&stored[..before.len()], before.as_slice());
                before.extend_from_slice(&stored[before.len()..]);
            }
        });
        assert!(before.iter().all(|stored| stored.len() > 20));
    }
}

#[test]
fn no_frame_and_no_link_ever_changes() {
    let (mut frames, mut links) = (Vec::new(), Vec::new());
    let session = drive("office", |session| {
        let mfis = session.mappers()[1].mfis();
        assert_eq!(&mfis.frames()[..frames.len()], frames.as_slice());
        assert_eq!(&mfis.links()[..links.len()], links.as_slice());
        (frames, links) = (mfis.frames().to_vec(), mfis.links().to_vec());
    });
    assert_eq!(session.record().mappers[1].name(), "consensus");
    assert!(frames.len() > 2 && links.len() > 1);
}
