use cogmap_geometry::DVec2;

use super::{Problem, World};
use crate::{BodyParams, Obstacles, Solids, driver::Planner};

/// Whether the robot can stand at its start, and get to every point of every route.
pub(super) fn problems(world: &World) -> Vec<Problem> {
    let obstacles = Obstacles::new(&Solids::of(world));
    let start = DVec2::from(world.start.position);
    if let Some(message) = buried(world, &obstacles, start) {
        return vec![Problem::new("start.position", message)];
    }
    let points: Vec<DVec2> = world.routes.values().flatten().map(|&point| point.into()).collect();
    let mut planner = Planner::new(world, &points, BodyParams::default().radius);
    let routes = world.routes.iter();
    routes.filter_map(|(name, route)| lost_on(name, route, start, &mut planner)).collect()
}

fn buried(world: &World, obstacles: &Obstacles, start: DVec2) -> Option<String> {
    let radius = BodyParams::default().radius;
    if let Some(i) = world.boxes.iter().position(|carton| carton.contains(start)) {
        return Some(format!("lies inside boxes[{i}]: move the start or the box"));
    }
    let nearest = obstacles.nearest(start, radius)?;
    let [x, y] = nearest.point.to_array();
    let gap = nearest.distance.max(0.0);
    Some(format!(
        "is {gap:.2} m from a solid at [{x:.2}, {y:.2}], and the robot needs {radius} m around its middle: \
         move the start"
    ))
}

/// The first point of a route that cannot be driven to.
fn lost_on(name: &str, route: &[[f64; 2]], start: DVec2, planner: &mut Planner) -> Option<Problem> {
    let mut from = start;
    for (k, &point) in route.iter().enumerate() {
        let to = DVec2::from(point);
        if let Err(message) = planner.way(from, to) {
            return Some(Problem::new(format!("routes.{name}[{k}]"), message));
        }
        from = to;
    }
    None
}
