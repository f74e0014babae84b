//! Two hundred short ways home, one line each in `tests/goldens/soak.jsonl`: what is driven and how it
//! ends, to the last bit. `tests/browser/soak.spec.ts` drives them on the page and compares. After a
//! wanted change run the tests with `UPDATE_GOLDENS=1`.

use std::{env, fs};

use cogmap_formats::world;
use cogmap_geometry::{DVec2, Pose};
use cogmap_mapping::MapperSetup;
use cogmap_simulation::{
    Building, Command, Driver, Ending, Robot, Session, SessionRecord, Source, Strategy, World,
};
use serde_json::{Value, json};

const GOLDEN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/goldens/soak.jsonl");
const EPISODES: u64 = 200;
/// Of so many episodes the test drives one; with `UPDATE_GOLDENS=1` it drives all.
const SAMPLE: u64 = 10;

/// The floors with the shortest ways out among the first ninety-nine.
const FLOORS: [u64; 4] = [60, 9, 11, 47];

/// What the page is asked for: a world that comes with it, or the number of a floor.
struct Wanted {
    world: &'static str,
    building: u64,
    robot: &'static str,
    strategy: &'static str,
    seed: u64,
}

impl Wanted {
    fn episode(number: u64) -> Self {
        let pick = |number: u64, count: usize| (number % count as u64) as usize;
        let strategies = Strategy::names();
        let strategy = strategies[pick(number, strategies.len())];
        let generated = number % 4 == 3;
        Self {
            world: if generated { "generated" } else { "around-a-corner" },
            building: if generated { FLOORS[pick(number / 4, FLOORS.len())] } else { 1 },
            robot: ["bad", "good"][pick(number / 7, 2)],
            strategy,
            seed: 1 + number,
        }
    }

    fn world(&self) -> World {
        if self.world == "generated" {
            return Building::generate(self.building);
        }
        world::read(include_str!("../../worlds/around-a-corner.world.json"), self.world).unwrap()
    }

    /// The whole episode, as the page and the command line drive it.
    fn drive(&self) -> Value {
        let (world, robot) = (self.world(), Robot::named(self.robot).unwrap());
        let (_, route) = world.routes.first_key_value().unwrap();
        let route: Vec<DVec2> = route.iter().map(|&point| point.into()).collect();
        let mut driver = Driver::new(&world, &robot, &route).unwrap();
        let mapper = MapperSetup::named("consensus").unwrap();
        let record = SessionRecord::new(Source::world(world, robot), vec![mapper], self.seed);
        let mut session = Session::drive(record).unwrap();
        driver.drive(&mut session);
        session.command(Command::GoHome { strategy: Strategy::named(self.strategy).unwrap() });
        while session.advance() && !session.at_rest() {}
        self.line(&session)
    }

    fn line(&self, session: &Session) -> Value {
        let Self { world, building, robot, strategy, seed } = *self;
        let way = session.way_home().unwrap();
        let ended = match way.ending {
            Some(Ending::Home) => "home",
            Some(Ending::Stuck(_)) => "stuck",
            Some(Ending::Stopped) | None => "stopped",
        };
        let Pose { position, heading } = session.world_from_robot().unwrap();
        json!({
            "world": world, "building": building, "robot": robot, "strategy": strategy, "seed": seed,
            "ended": ended, "position": session.position(), "decisions": way.decisions.len(),
            "pose": [position.x, position.y, heading],
            "distance": way.distance, "believed": way.believed,
        })
    }
}

#[test]
fn short_ways_home_end_as_the_page_is_told_they_end() {
    let update = env::var_os("UPDATE_GOLDENS").is_some();
    if update {
        let lines = (0..EPISODES).map(|number| format!("{}\n", Wanted::episode(number).drive()));
        fs::write(GOLDEN, lines.collect::<String>()).unwrap();
    }
    let known = fs::read_to_string(GOLDEN).unwrap();
    assert_eq!(known.lines().count() as u64, EPISODES);
    for (number, known) in (0..).zip(known.lines()).step_by(SAMPLE as usize) {
        assert_eq!(Wanted::episode(number).drive().to_string(), known, "episode {number}");
    }
}
