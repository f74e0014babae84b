//! A drive of which each mapper's map has its SHA-256 in `tests/goldens/same-bytes.txt`; the tests of `cogmap-wasm` replay
//! the same session in Node and in a browser and compare with the same file. After a wanted change
//! run the tests with `UPDATE_GOLDENS=1`.

use std::{env, fs, path::PathBuf};

use cogmap_formats::{run, session, sha256_hex, world};
use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Command, Robot, Session, SessionRecord, Source};

fn golden(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("goldens").join(name)
}

/// Drives the bad robot about the office by hand: every kind of command, a wall in the way, and
/// readings between the steps.
fn drive() -> Session {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../worlds/office.world.json");
    let office = world::read(&fs::read_to_string(file).unwrap(), file).unwrap();
    let source = Source::world(office, Robot::named("bad").unwrap());
    let mappers = MapperSetup::NAMES.iter().filter_map(|name| MapperSetup::named(name)).collect();
    let mut session = Session::drive(SessionRecord::new(source, mappers, 7)).unwrap();
    for round in 0..6 {
        let bend = f64::from(round) * 0.4 - 0.9;
        for command in [
            Command::Step { turn: bend, travel: 0.7 },
            Command::Step { turn: -bend, travel: 0.5 },
            Command::Drive { linear: 0.5, angular: -bend },
            Command::Stop,
        ] {
            session.command(command);
            for _ in 0..120 {
                session.advance();
            }
        }
    }
    session
}

/// One line a mapper.
fn map_digests(session: &Session) -> String {
    let maps = (0..session.mappers().len()).map(|mapper| run::map(session, mapper));
    maps.map(|map| sha256_hex(map.as_bytes()) + "\n").collect()
}

#[test]
fn one_session_gives_the_same_bytes_everywhere() {
    if env::var_os("UPDATE_GOLDENS").is_some() {
        let session = drive();
        fs::write(golden("same-bytes.session.json"), session::write(session.record())).unwrap();
        fs::write(golden("same-bytes.txt"), map_digests(&session)).unwrap();
    }
    let file = fs::read_to_string(golden("same-bytes.session.json")).unwrap();
    let record = session::read(&file, "same-bytes.session.json").unwrap().record;
    let mut session = Session::drive(record).unwrap();
    session.jump(session.end());
    assert!(session.mappers()[0].mfis().surfaces().len() > 50, "the drive has something to compare");
    assert_eq!(map_digests(&session), fs::read_to_string(golden("same-bytes.txt")).unwrap());
}
