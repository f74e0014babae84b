//! Drives of which each mapper's map has its SHA-256 in `tests/goldens/`: a session driven by hand in
//! `same-bytes.txt`, the first steps through every designed world in `same-bytes-worlds.txt`; and ways
//! home with every strategy, their decisions included, in `same-bytes-homing.txt`. The tests of `cogmap-wasm` do the same in Node and in a browser and compare with the same files. After
//! a wanted change run the tests with `UPDATE_GOLDENS=1`.

mod first_steps;
mod ways_home;

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

#[test]
fn every_mapper_gives_the_same_bytes_everywhere_in_every_designed_world() {
    let digests: String =
        first_steps::WORLDS.iter().map(|(name, file)| first_steps::digests(name, file)).collect();
    compare(&digests, "same-bytes-worlds.txt");
}

#[test]
fn every_strategy_goes_the_same_way_home_everywhere() {
    let digests: String =
        ways_home::WORLDS.iter().map(|(name, file)| ways_home::digests(name, file)).collect();
    compare(&digests, "same-bytes-homing.txt");
}

/// Compares a table with its golden, line by line.
fn compare(table: &str, name: &str) {
    if env::var_os("UPDATE_GOLDENS").is_some() {
        fs::write(golden(name), table).unwrap();
    }
    let known = fs::read_to_string(golden(name)).unwrap();
    for (line, known) in table.lines().zip(known.lines()) {
        assert_eq!(line, known);
    }
    assert_eq!(table.lines().count(), known.lines().count());
}

#[test]
fn no_designed_world_is_left_out() {
    let worlds = fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../worlds")).unwrap();
    let names = worlds.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> =
        names.filter_map(|name| Some(name.strip_suffix(".world.json")?.to_owned())).collect();
    names.sort_unstable();
    assert_eq!(names, first_steps::WORLDS.map(|(name, _)| name));
}
