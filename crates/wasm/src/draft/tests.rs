use cogmap_formats::world;

use super::*;

const FULL: &str = r#"{ "$schema": "./cogmap-world.schema.json", "format": "cogmap-world/1", "name": "Hall", "description": "A hall.",
    "walls": [[[0,0],[8,0],[8,6],[0,6],[0,0]], [[4,0],[4,2]]],
    "boxes": [{"center": [6,4], "size": [1,0.5], "heading_deg": 30}], "posts": [{"center": [2,5], "radius": 0.02}],
    "doors": [{"name": "a", "hinge": [6,2], "latch": [6.9,2], "open": true}],
    "people": [{"path": [[1,5],[7,5]], "speed": 0.8, "radius": 0.25}],
    "start": {"position": [1,1], "heading_deg": 90}, "routes": {"b": [[3,1]], "a": [[3,1],[3,5]]},
    "rooms": [{"name": "hall", "outline": [[0,0],[8,0],[8,6]]}] }"#;

fn full() -> Draft {
    Draft::of(world::parse(FULL, "hall.world.json").unwrap())
}

#[test]
fn a_world_comes_back_from_its_sheet_as_it_was_and_its_file_to_the_byte() {
    let world = world::parse(FULL, "hall.world.json").unwrap();
    assert_eq!(full().world(), Some(world.clone()));
    let checked = Checked::of(&full());
    assert_eq!((checked.faults, checked.remarks), (Vec::new(), Vec::new()));
    assert_eq!((checked.file.as_str(), &checked.text), ("hall.world.json", &world::write(&world)));
    let again = Draft::of(world::read(&checked.text, "again").unwrap());
    assert_eq!(Checked::of(&again).text, checked.text);
}

#[test]
fn a_blank_sheet_can_be_used_as_it_is() {
    assert_eq!(Checked::of(&Draft::blank("New building".to_owned())).faults, []);
}

/// The list of the thing that the only fault of a draft is at, and at which of its points.
fn where_it_is(spoil: impl FnOnce(&mut Draft)) -> (&'static str, Option<usize>) {
    let mut draft = full();
    spoil(&mut draft);
    let faults = Checked::of(&draft).faults;
    let [fault] = faults.as_slice() else { panic!("{faults:?}") };
    let kind = fault.thing.map_or("", |index| draft.things[index].list());
    (kind, fault.point)
}

#[test]
fn each_fault_is_found_on_the_sheet() {
    let add = |thing: Thing| move |draft: &mut Draft| draft.things.insert(0, thing);
    let door = |latch| Thing::Door { name: "d".to_owned(), hinge: [5.0, 5.0], latch, open: false };
    let route = |points| Thing::Route { name: "a.b[0]".to_owned(), points };
    assert_eq!(where_it_is(add(Thing::Wall { points: vec![[1.0, 1.0], [2.0, 1.0]] })), ("start", None));
    assert_eq!(where_it_is(add(Thing::Wall { points: vec![[5.0, 3.0]; 2] })), ("walls", Some(1)));
    assert_eq!(where_it_is(add(door([5.0, 5.0]))), ("doors", Some(1)));
    assert_eq!(
        where_it_is(|draft| draft.things.extend([door([5.0, 5.9]), door([5.9, 5.0])])),
        ("doors", None)
    );
    assert_eq!(where_it_is(add(route(vec![[3.0, 1.0], [4.0, 1.0]]))), ("routes", Some(1)));
    assert_eq!(where_it_is(add(route(vec![[3.0, 1.0], [9.0, 9.0]]))), ("routes", Some(1)));
    let again = Thing::Route { name: "b".to_owned(), points: vec![[3.0, 1.0]] };
    assert_eq!(where_it_is(|draft| draft.things.push(again)), ("routes", None));
    let far = Thing::Room { name: "r".to_owned(), points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1e6]] };
    assert_eq!(where_it_is(add(far)), ("rooms", Some(2)));
    let flat = Thing::Box { center: [3.0, 5.0], size: [1.0, 0.0], heading_deg: 0.0 };
    assert_eq!(where_it_is(add(flat)), ("boxes", None));
    let nowhere = Thing::Wall { points: vec![[5.0, 3.0], [f64::NAN, 3.0]] };
    assert_eq!(where_it_is(add(nowhere)), ("walls", Some(1)));
    assert_eq!(where_it_is(|draft| draft.things.retain(|it| !matches!(it, Thing::Start { .. }))), ("", None));
}

#[test]
fn files_are_called_after_the_building_in_plain_letters() {
    for (name, file) in [
        ("Corner office", "corner-office.world.json"),
        ("../Büro № 7!", "b-ro-7.world.json"),
        ("事務所", "building.world.json"),
        ("", "building.world.json"),
    ] {
        assert_eq!(file_name(name), file);
    }
}
