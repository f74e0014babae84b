use super::*;
use crate::Person;

/// Down a corridor of 8 × 2.4 m; then somebody crosses the way back to and fro, and home.
fn homed(strategy: &str, speed: f64) -> Session {
    let text = r#"{ "format": "cogmap-world/1", "name": "Corridor",
        "walls": [[[0,0],[8,0],[8,2.4],[0,2.4],[0,0]]],
        "start": {"position": [1,1.2]} }"#;
    let source = Source::world(serde_json::from_str(text).unwrap(), Robot::named("bad").unwrap());
    let mapper = MapperSetup::Consensus(Box::default());
    let mut session = Session::drive(SessionRecord::new(source, vec![mapper], 3)).unwrap();
    for _ in 0..6 {
        session.command(Command::Step { turn: 0.0, travel: 0.8 });
        run_to_rest(&mut session);
    }
    let path = vec![[3.5, 0.4], [3.5, 2.0]];
    session.command(Command::Change(WorldChange::AddPerson(Person { path, speed, radius: 0.25 })));
    session.advance();
    session.command(Command::GoHome { strategy: Strategy::named(strategy).unwrap() });
    session
}

#[test]
fn nobody_who_crosses_the_way_is_touched_on_the_way_home() {
    let mut wrong = Vec::new();
    for strategy in ["recommended", "tangent-bug", "oracle"] {
        for speed in [0.5, 0.8, 1.1] {
            let mut session = homed(strategy, speed);
            run_to_rest(&mut session);
            let kinds = kinds(&session);
            let touched = kinds.iter().any(|kind| kind == "collision");
            let truth = session.world_from_robot().unwrap();
            let far = truth.position.distance((1.0, 1.2).into());
            if touched || kinds.last().unwrap() != "home" || far > 0.6 {
                wrong.push(format!("{strategy}, {speed} m/s: {far:.2} m, {kinds:?}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
