use super::*;
use crate::{Building, Command, Robot, Session, SessionRecord, Source};

fn floor(seed: u64) -> (World, Vec<DVec2>) {
    let world = Building::generate(seed);
    let route = world.routes["out"].iter().map(|&point| point.into()).collect();
    (world, route)
}

#[test]
fn every_setting_can_be_simulated_and_leaves_a_way_home_but_the_one_that_must_not() {
    let mut made = [0; Setting::ALL.len()];
    for seed in 1..20 {
        let (world, route) = floor(seed);
        for (k, setting) in Setting::ALL.into_iter().enumerate() {
            let Some(episode) = Episode::new(&world, &route, setting, seed) else { continue };
            made[k] += 1;
            assert_eq!(episode.world.problems(), [], "seed {seed}, {}", setting.name());
            let (home, end) = (world.start.position.into(), *route.last().unwrap());
            let leads = Reach::AMPLE.leads(&episode.world_at_command(), end, home);
            assert_eq!(leads, setting != Setting::NoWay, "seed {seed}, {}", setting.name());
        }
    }
    // Not every way leads through a door whose closing leaves another way; most of the rest can be had.
    assert!(made.iter().all(|&made| made >= 3), "{made:?}");
    assert!([0, 1, 2, 5, 6, 7].iter().all(|&k| made[k] >= 15), "{made:?}");
}

#[test]
fn the_same_seed_makes_the_same_episode() {
    let (world, route) = floor(5);
    for setting in Setting::ALL {
        assert_eq!(Episode::new(&world, &route, setting, 5), Episode::new(&world, &route, setting, 5));
        assert_eq!(Setting::named(setting.name()), Some(setting));
    }
}

#[test]
fn cartons_fall_on_the_way_and_a_narrow_course_leaves_it_free() {
    let (world, route) = floor(2);
    let dropped = Episode::new(&world, &route, Setting::BoxesDropped, 2).unwrap();
    for change in &dropped.changes {
        let WorldChange::AddBox { center, .. } = change else { panic!("{change:?}") };
        let off = route.iter().map(|point| point.distance(DVec2::from(*center))).fold(9.0, f64::min);
        assert!(off < 0.5, "{off}");
    }
    let narrow = Episode::new(&world, &route, Setting::Narrow, 2).unwrap();
    for carton in &narrow.world.boxes[world.boxes.len()..] {
        let edges = carton.edges();
        let near =
            |leg: cogmap_geometry::Segment| edges.iter().any(|e| e.distance_to(leg.midpoint()) < 0.375);
        assert!(!reach::legs(world.start.position.into(), &route).any(near));
    }
}

#[test]
fn people_come_when_they_are_called_and_not_onto_the_robot() {
    let (world, route) = floor(3);
    let episode = Episode::new(&world, &route, Setting::People, 3).unwrap();
    let source = Source::world(episode.world.clone(), Robot::named("perfect").unwrap());
    let mut session = Session::drive(SessionRecord::new(source, Vec::new(), 3)).unwrap();
    for change in &episode.changes {
        assert_eq!(session.refusal(&Command::Change(change.clone())), None);
        session.command(Command::Change(change.clone()));
        session.advance();
    }
    assert_eq!(session.people().len(), episode.changes.len());
    let before = session.people().to_vec();
    let mut other = session.forked();
    (0..50).for_each(|_| {
        session.advance();
        other.advance();
    });
    assert!(session.people() != before, "they walk");
    assert_eq!(session.people(), other.people(), "the same whether or not the run was forked");
    let WorldChange::AddPerson(person) = &episode.changes[0] else { panic!("{:?}", episode.changes) };
    let path = vec![world.start.position];
    let onto = WorldChange::AddPerson(crate::Person { path, ..person.clone() });
    assert!(session.refusal(&Command::Change(onto)).unwrap().contains("robot"));
    let nowhere = WorldChange::AddPerson(crate::Person { path: Vec::new(), ..person.clone() });
    assert!(session.refusal(&Command::Change(nowhere)).is_some());
}
