//! Situations: a run at a moment, said as shortly as it can be. The page's links hold them, and what a
//! browser keeps of a run.
//!
//! A situation is a session whose known parts are named instead of spelled out (a building that comes with
//! the page, a robot, a mapper), without the parameters that have their default values, and with the moment
//! that is shown.

use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Robot, SESSION_FORMAT, SessionRecord, Source, World};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

use crate::{FormatError, json::Piece, session, sha256_hex};

/// So many digits of a building's SHA-256 tell whether it is still the same.
const DIGEST: usize = 12;

/// A run at a moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Situation {
    /// Everything that the run depends on.
    pub record: SessionRecord,
    /// The moment that is shown, in ticks or readings.
    pub at: u64,
    /// Whether the robot may go on beyond what is recorded.
    pub live: bool,
    /// Whether it was being driven along the building's first route.
    pub on_route: bool,
}

/// A situation as read.
#[derive(Clone, Debug, PartialEq)]
pub struct SituationFile {
    /// What was read.
    pub situation: Situation,
    /// The building by the name under which the page knows it.
    pub building: Option<String>,
    /// Whether robot and mappers are known by name as well.
    pub plain: bool,
    /// What may make this run differ from the recorded one, each a sentence.
    pub warnings: Vec<String>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Said {
    engine: String,
    source: Value,
    mappers: Vec<Value>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    navigator: Option<Value>,
    seed: u64,
    at: u64,
    live: bool,
    on_route: bool,
}

/// The situation as text. `building` is the name under which whoever reads it knows the building.
#[must_use]
pub fn write(situation: &Situation, building: Option<&str>) -> String {
    let Situation { record, at, live, on_route } = situation;
    let mut source = value(&record.source);
    if let Source::World { world, robot, .. } = &record.source {
        source["robot"] = short_robot(robot);
        if let Some(building) = building {
            source["world"] = json!({ "named": building, "digest": digest(world) });
        }
    }
    let said = Said {
        engine: record.engine.clone(),
        source,
        mappers: record.mappers.iter().map(short_mapper).collect(),
        navigator: record.navigator.as_ref().map(short_mapper),
        seed: record.seed,
        at: *at,
        live: *live,
        on_route: *on_route,
    };
    value(&said).to_string()
}

/// Reads a situation and makes sure that it can be run. `file` is the name for messages, `building` finds
/// a building by its name.
///
/// # Errors
/// [`FormatError`] with the place and the way out.
pub fn read(
    text: &str,
    file: &str,
    building: impl Fn(&str) -> Option<World>,
) -> Result<SituationFile, FormatError> {
    let piece = Piece::whole(text, file);
    let Said { engine, mut source, mappers, navigator, seed, at, live, on_route } = piece.read()?;
    let named = find_building(&piece, &mut source, &engine, building)?;
    let plain = is_name(source.get("robot")) && mappers.iter().chain(&navigator).all(Value::is_string);
    if let Some(robot) = source.get_mut("robot") {
        *robot = whole_robot(robot.take());
    }
    let mappers: Vec<_> = mappers.into_iter().map(whole_mapper).collect();
    let mut whole = json!({
        "format": SESSION_FORMAT, "engine": engine, "source": source, "mappers": mappers, "seed": seed
    });
    if let Some(navigator) = navigator {
        whole["navigator"] = whole_mapper(navigator);
    }
    let session::SessionFile { record, warnings } = session::read(&whole.to_string(), file)?;
    let situation = Situation { record, at, live, on_route };
    Ok(SituationFile { situation, plain: plain && named.is_some(), building: named, warnings })
}

/// Puts the building in the place of its name, which it returns.
fn find_building(
    piece: &Piece<'_>,
    source: &mut Value,
    engine: &str,
    find: impl Fn(&str) -> Option<World>,
) -> Result<Option<String>, FormatError> {
    let Some(world) = source.get_mut("world") else { return Ok(None) };
    let Some(name) = world.get("named").and_then(Value::as_str).map(str::to_owned) else { return Ok(None) };
    let wrong = |problem: String| FormatError::Json {
        place: piece.locate("source.world"),
        problem: crate::error::tame(&problem),
        remedy: crate::error::tame(&format!("open it with version {engine}, which made it")),
    };
    let found = find(&name).ok_or_else(|| wrong(format!("there is no building called `{name}` here")))?;
    if world.get("digest").and_then(Value::as_str) != Some(&digest(&found)) {
        return Err(wrong(format!("the building `{name}` is not the one that was meant")));
    }
    *world = value(&found);
    Ok(Some(name))
}

fn digest(world: &World) -> String {
    let mut digest = sha256_hex(value(world).to_string().as_bytes());
    digest.truncate(DIGEST);
    digest
}

fn short_robot(robot: &Robot) -> Value {
    if Robot::named(&robot.name).as_ref() == Some(robot) {
        return robot.name.clone().into();
    }
    let basis: Option<Robot> = serde_json::from_value(json!({ "name": robot.name })).ok();
    let mut short = differing(value(robot), &value(&basis));
    short["name"] = robot.name.clone().into();
    short
}

fn whole_robot(said: Value) -> Value {
    said.as_str().and_then(Robot::named).map_or(said, |robot| value(&robot))
}

fn short_mapper(mapper: &MapperSetup) -> Value {
    let basis = MapperSetup::named(mapper.name());
    if basis.as_ref() == Some(mapper) {
        return mapper.name().into();
    }
    let mut short = differing(value(mapper), &value(&basis));
    short["mapper"] = mapper.name().into();
    short
}

fn whole_mapper(said: Value) -> Value {
    if said.is_string() { json!({ "mapper": said }) } else { said }
}

fn is_name(value: Option<&Value>) -> bool {
    value.is_some_and(Value::is_string)
}

/// The members of an object, and of the objects in it, that are not as in `basis`.
fn differing(value: Value, basis: &Value) -> Value {
    let Value::Object(members) = value else { return value };
    let differing_members = members.into_iter().filter_map(|(key, member)| match basis.get(&key) {
        Some(same) if *same == member => None,
        Some(other) => Some((key, differing(member, other))),
        None => Some((key, member)),
    });
    Value::Object(differing_members.collect::<Map<_, _>>())
}

/// Only a map whose keys are no strings could fail, and no session has one.
fn value<T: Serialize>(it: &T) -> Value {
    serde_json::to_value(it).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use cogmap_simulation::{Building, Command, TimedCommand};

    use super::*;

    fn office(number: &str) -> Option<World> {
        number.strip_prefix("generated:")?.parse().ok().map(Building::generate)
    }

    fn situation() -> Situation {
        let source = Source::World {
            world: Building::generate(7),
            robot: Robot::named("bad").unwrap(),
            commands: vec![
                TimedCommand { tick: 0, command: Command::Step { turn: 0.1 + 0.2, travel: 1.0 } },
                TimedCommand { tick: 90, command: Command::Stop },
            ],
            ticks: 90,
        };
        let mappers = MapperSetup::NAMES.iter().filter_map(|name| MapperSetup::named(name)).collect();
        let record = SessionRecord::new(source, mappers, u64::MAX);
        Situation { record, at: 40, live: true, on_route: false }
    }

    fn mistake(text: &str) -> String {
        read(text, "the link", office).unwrap_err().to_string()
    }

    #[test]
    fn a_situation_among_known_things_is_short_and_survives() {
        let text = write(&situation(), Some("generated:7"));
        assert!(text.len() < 400, "{text}");
        let read = read(&text, "the link", office).unwrap();
        assert_eq!(read.situation, situation());
        assert_eq!(read.building.as_deref(), Some("generated:7"));
        assert!(read.plain && read.warnings.is_empty());
    }

    #[test]
    fn what_differs_from_the_default_survives_too() {
        let mut made = situation();
        if let Source::World { robot, .. } = &mut made.record.source {
            robot.laser.noise = 0.02;
        }
        if let Some(MapperSetup::Perceptual(params)) = made.record.mappers.first_mut() {
            params.matching.distance = 0.7;
        }
        made.record.navigator = Some(made.record.mappers.remove(0));
        let text = write(&made, None);
        assert!(text.contains(r#"{"mapper":"perceptual","matching":{"distance":0.7}}"#), "{text}");
        let read = read(&text, "the link", office).unwrap();
        assert_eq!(read.situation, made);
        assert!(!read.plain && read.building.is_none());
    }

    #[test]
    fn a_log_is_named_by_its_digest() {
        let source = Source::Log {
            path: "a.log".to_owned(),
            sha256: "0".repeat(64),
            every: None,
            odometry_noise: 0.0,
        };
        let record = SessionRecord::new(source, vec![MapperSetup::named("odometry").unwrap()], 1);
        let made = Situation { record, at: 3, live: false, on_route: false };
        assert_eq!(read(&write(&made, None), "kept", office).unwrap().situation, made);
    }

    #[test]
    fn what_is_wrong_is_said_with_its_place() {
        let text = write(&situation(), Some("generated:7"));
        let message = mistake(&text.replace("generated:7", "castle"));
        assert!(message.contains("`castle`") && message.contains("source.world"), "{message}");
        let message = mistake(&text.replace("generated:7", "generated:8"));
        assert!(message.contains("not the one") && message.contains("version"), "{message}");
        assert!(mistake(&text.replace("\"bad\"", "\"worse\"")).contains("source.robot"));
        assert!(mistake(&text.replace("\"perceptual\"", "\"psychic\"")).contains("psychic"));
        assert!(mistake(&text.replace("\"live\"", "\"alive\"")).contains("alive"));
        assert!(mistake(&text.replace("\"ticks\":90", "\"ticks\":1000000000000000000")).contains("ticks"));
        assert!(mistake("[]").starts_with("the link"));
        assert!(mistake(&text[..text.len() / 2]).starts_with("the link"));
    }
}
