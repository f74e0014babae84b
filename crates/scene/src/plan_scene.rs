use cogmap_geometry::{DVec2, Pose};
use cogmap_simulation::{BodyParams, Disc, World};

use crate::{
    Item, Role, Sample, Scene, Shape, WorldOptions,
    world_scene::{draw_people, draw_world},
};

/// A building as its author draws it, before any robot drives in it: all of the world, the robot at its
/// start, and the routes.
#[must_use]
pub fn plan_scene(world: &World) -> Scene {
    let mut scene = Scene { title: world.name.clone(), ..Scene::default() };
    draw_world(&mut scene, world, WorldOptions::default());
    let start = DVec2::from(world.start.position);
    for route in world.routes.values() {
        let points = std::iter::once(start).chain(route.iter().copied().map(DVec2::from)).collect();
        scene.changing.push(Item::new(Role::TruePath, Shape::Arrow(points)));
    }
    if !world.routes.is_empty() {
        scene.explain(Sample::Line(Role::TruePath), "route");
    }
    let feet = |path: &Vec<[f64; 2]>| path.first().copied().map(DVec2::from);
    let people = world.people.iter();
    let people: Vec<Disc> =
        people.filter_map(|it| Some(Disc { center: feet(&it.path)?, radius: it.radius })).collect();
    draw_people(&mut scene, &people);
    let robot = Pose::new(start.x, start.y, world.start.heading_deg.to_radians());
    scene.changing.push(Item::new(Role::Robot, Shape::Robot(robot, BodyParams::default().radius)));
    scene
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_plan_shows_the_robot_at_its_start_and_the_routes_from_there() {
        let text = r#"{ "format": "cogmap-world/1", "name": "Hall", "start": {"position": [1, 2], "heading_deg": 90},
            "walls": [[[0,0],[4,0]]], "routes": {"tour": [[3,2]]}, "people": [{"path": [], "speed": 1, "radius": 0.2}] }"#;
        let scene = plan_scene(&serde_json::from_str(text).unwrap());
        let start = DVec2::new(1.0, 2.0);
        let way = Shape::Arrow(vec![start, DVec2::new(3.0, 2.0)]);
        assert!(scene.changing.contains(&Item::new(Role::TruePath, way)));
        let Some(Shape::Robot(robot, _)) = scene.changing.last().map(|item| &item.shape) else { panic!() };
        assert_eq!(robot.position, start);
        assert!(robot.forward().distance(DVec2::Y) < 1e-12);
    }
}
