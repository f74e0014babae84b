//! A run for unit tests.

use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Command, Robot, Session, SessionRecord, Source, World};

use crate::run::{Label, Run};

/// A robot that has driven through a door of 0.8 m into another room, seen by two mappers.
pub(crate) fn two_rooms() -> Run {
    let world: World = serde_json::from_str(
        r#"{"format": "cogmap-world/1", "name": "Two rooms", "start": {"position": [2, 2.5]},
            "walls": [[[0,0],[12,0],[12,5],[0,5],[0,0]], [[6,0],[6,2.1]], [[6,2.9],[6,5]]]}"#,
    )
    .unwrap();
    let source = Source::world(world, Robot::named("bad").unwrap());
    let mappers = ["perceptual", "odometry"].map(|name| MapperSetup::named(name).unwrap());
    let session = Session::drive(SessionRecord::new(source, mappers.into(), 1)).unwrap();
    let label = Label {
        name: String::new(),
        stem: String::new(),
        foreign: false,
        settled: false,
        building: None,
        warnings: Vec::new(),
    };
    let mut run = Run::new(session, label, None);
    drive(&mut run, 15);
    run
}

/// Lets the robot take so many steps straight ahead.
pub(crate) fn drive(run: &mut Run, steps: usize) {
    for _ in 0..steps {
        run.enter(Command::Step { turn: 0.0, travel: 0.5 });
        while run.advance() {}
    }
}
