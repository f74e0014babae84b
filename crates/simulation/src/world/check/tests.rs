use proptest::prelude::*;

use super::*;

const ROOM: &str = r#""walls": [[[0,0],[8,0],[8,6],[0,6],[0,0]]], "start": {"position": [1,1]}"#;

fn world(content: &str) -> World {
    let text = format!(r#"{{"format": "cogmap-world/1", "name": "test", {content}}}"#);
    serde_json::from_str(&text).unwrap()
}

/// Where the problems of a room with something added are.
fn places(added: &str) -> Vec<String> {
    world(&format!("{ROOM}, {added}")).problems().into_iter().map(|problem| problem.place).collect()
}

#[test]
fn a_sound_world_has_no_problems() {
    let added = r#""boxes": [{"center": [4,3], "size": [1,1]}], "posts": [{"center": [2,5], "radius": 0.02}],
        "doors": [{"name": "a", "hinge": [6,3], "latch": [6.9,3]}, {"name": "b", "hinge": [6,4], "latch": [6.9,4]}],
        "people": [{"path": [[1,5],[7,5]], "speed": 0.8, "radius": 0.25}], "routes": {"tour": [[3,1],[4,5]]},
        "rooms": [{"name": "hall", "outline": [[0,0],[8,0],[8,6]]}]"#;
    assert_eq!(world(&format!("{ROOM}, {added}")).problems(), []);
}

#[test]
fn each_fault_is_named_where_it_is() {
    let faults = [
        (r#""boxes": [{"center": [4,3], "size": [1,0]}]"#, "boxes[0].size[1]"),
        (r#""boxes": [{"center": [4,3], "size": [-1,1]}]"#, "boxes[0].size[0]"),
        (r#""boxes": [{"center": [4,30000], "size": [1,1]}]"#, "boxes[0].center[1]"),
        (r#""boxes": [{"center": [4,3], "size": [1,1], "heading_deg": 1e300}]"#, "boxes[0].heading_deg"),
        (r#""boxes": [{"center": [1.1,1], "size": [1,1]}]"#, "start.position"),
        (r#""boxes": [{"center": [1.1,1], "size": [9,9]}]"#, "start.position"),
        (r#""posts": [{"center": [4,3], "radius": 0}]"#, "posts[0].radius"),
        (r#""posts": [{"center": [1.2,1], "radius": 0.02}]"#, "start.position"),
        (r#""doors": [{"name": "d", "hinge": [4,3], "latch": [4,3]}]"#, "doors[0].latch"),
        (
            r#""doors": [{"name": "d", "hinge": [4,3], "latch": [4,4]}, {"name": "d", "hinge": [5,3], "latch": [5,4]}]"#,
            "doors[1].name",
        ),
        (r#""people": [{"path": [], "speed": 1, "radius": 0.2}]"#, "people[0].path"),
        (r#""people": [{"path": [[1,1]], "speed": -1, "radius": 0.2}]"#, "people[0].speed"),
        (r#""routes": {"tour": []}"#, "routes.tour"),
        (r#""routes": {"tour": [[3,1],[9,1]]}"#, "routes.tour[1]"),
        (r#""routes": {"tour": [[3,1],[7.9,1]]}"#, "routes.tour[1]"),
        (r#""rooms": [{"name": "r", "outline": [[0,0],[1,1]]}]"#, "rooms[0].outline"),
    ];
    for (added, place) in faults {
        assert_eq!(places(added), [place], "{added}");
    }
}

#[test]
fn faulty_walls_and_formats_are_named() {
    let place = |content: &str| world(content).problems().into_iter().map(|p| p.place).collect::<Vec<_>>();
    let start = r#""start": {"position": [1,1]}"#;
    assert_eq!(place(&format!(r#""walls": [[[0,0]]], {start}"#)), ["walls[0]"]);
    assert_eq!(place(&format!(r#""walls": [[[0,0],[3,0],[3,0]]], {start}"#)), ["walls[0][2]"]);
    assert_eq!(place(r#""start": {"position": [1,1e9]}"#), ["start.position[1]"]);
    let foreign = World { format: "stage".into(), ..world(start) };
    assert_eq!(foreign.problems()[0].place, "format");
}

#[test]
fn a_message_says_what_is_there_and_what_to_do() {
    let world = world(&format!(r#"{ROOM}, "routes": {{"tour": [[7.9,1]]}}"#));
    let message = &world.problems()[0].message;
    assert!(message.contains("0.10 m from a solid at [8.00, 1.00]") && message.contains("move"), "{message}");
}

#[test]
fn a_world_that_is_too_large_is_refused_before_it_is_looked_at() {
    let mut world = world(ROOM);
    world.walls.push((0..200_000).map(|k| [f64::from(k % 7), f64::from(k % 5)]).collect());
    let problems = world.problems();
    assert_eq!(problems.len(), 1);
    assert!(problems[0].message.contains("at most 100000"), "{}", problems[0].message);
}

#[test]
fn a_world_full_of_walls_is_looked_at_in_time() {
    let mut world = world(r#""start": {"position": [0,-9000]}"#);
    let wall = |k: i32| vec![[-9999.0, f64::from(k) / 9.0], [9999.0, -f64::from(k) / 9.0]];
    world.walls = (-30_000..30_000).map(wall).collect();
    world.routes.insert("tour".into(), (0..9000).map(|k| [f64::from(k), 9000.0]).collect());
    assert_eq!(world.problems().len(), 1);
}

fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![-10.0f64..10.0, any::<f64>(), Just(0.0), Just(-0.0), Just(1e4), Just(f64::NAN)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn no_world_makes_the_check_panic(
        walls in prop::collection::vec(prop::collection::vec([any_number(), any_number()], 0..4), 0..4),
        boxes in prop::collection::vec(([any_number(), any_number()], [any_number(), any_number()], any_number()), 0..3),
        start in [any_number(), any_number()],
        route in prop::collection::vec([any_number(), any_number()], 0..3),
    ) {
        let mut world = world(ROOM);
        world.walls = walls;
        world.start.position = start;
        world.routes.insert("tour".into(), route);
        world.boxes = boxes.into_iter()
            .map(|(center, size, heading_deg)| super::super::BoxObstacle { center, size, heading_deg })
            .collect();
        let problems = world.problems();
        prop_assert!(problems.len() < 99);
        prop_assert!(problems.iter().all(|p| !p.place.is_empty() && p.message.contains(": ") || p.message.contains("expected")));
    }
}
