use super::{Problem, World};

/// No coordinate of a world may be farther from its origin, metres.
const COORDINATE_MAX: f64 = 10_000.0;
/// Lengths, widths and radii lie between these, metres.
const SIZES: [f64; 2] = [0.001, 1000.0];
/// People walk at speeds between these, metres per second.
const SPEEDS: [f64; 2] = [0.0, 5.0];
/// How many wrong numbers are told one by one.
const TOLD_MAX: usize = 20;

/// Numbers that are not finite, far outside any building, or no size at all; the first few.
pub(super) fn problems(world: &World) -> Vec<Problem> {
    let points = points(world).into_iter().flat_map(|(place, point)| {
        point.into_iter().enumerate().filter_map(move |(k, value)| {
            outside(value, [-COORDINATE_MAX, COORDINATE_MAX])
                .map(|m| Problem::new(format!("{place}[{k}]"), m))
        })
    });
    let numbers = numbers(world).into_iter();
    let numbers =
        numbers.filter_map(|(place, value, bounds)| Some(Problem::new(place, outside(value, bounds)?)));
    points.chain(numbers).take(TOLD_MAX).collect()
}

fn outside(value: f64, [low, high]: [f64; 2]) -> Option<String> {
    let wrong = !(low..=high).contains(&value);
    wrong.then(|| format!("is {value}; expected a number from {low} to {high}"))
}

/// Every point of the file and its place.
fn points(world: &World) -> Vec<(String, [f64; 2])> {
    let mut all = vec![("start.position".to_owned(), world.start.position)];
    let mut line = |place: String, points: &[[f64; 2]]| {
        all.extend(points.iter().enumerate().map(|(k, &point)| (format!("{place}[{k}]"), point)));
    };
    for (i, wall) in world.walls.iter().enumerate() {
        line(format!("walls[{i}]"), wall);
    }
    for (i, person) in world.people.iter().enumerate() {
        line(format!("people[{i}].path"), &person.path);
    }
    for (i, room) in world.rooms.iter().enumerate() {
        line(format!("rooms[{i}].outline"), &room.outline);
    }
    for (name, route) in &world.routes {
        line(format!("routes.{name}"), route);
    }
    all.extend(world.boxes.iter().enumerate().map(|(i, it)| (format!("boxes[{i}].center"), it.center)));
    all.extend(world.posts.iter().enumerate().map(|(i, it)| (format!("posts[{i}].center"), it.center)));
    for (i, door) in world.doors.iter().enumerate() {
        all.push((format!("doors[{i}].hinge"), door.hinge));
        all.push((format!("doors[{i}].latch"), door.latch));
    }
    all
}

/// Every other number of the file, its place and its bounds.
fn numbers(world: &World) -> Vec<(String, f64, [f64; 2])> {
    let angles = [-COORDINATE_MAX, COORDINATE_MAX];
    let mut all = vec![("start.heading_deg".to_owned(), world.start.heading_deg, angles)];
    for (i, carton) in world.boxes.iter().enumerate() {
        all.extend((0..2).map(|k| (format!("boxes[{i}].size[{k}]"), carton.size[k], SIZES)));
        all.push((format!("boxes[{i}].heading_deg"), carton.heading_deg, angles));
    }
    all.extend(
        world.posts.iter().enumerate().map(|(i, it)| (format!("posts[{i}].radius"), it.radius, SIZES)),
    );
    for (i, person) in world.people.iter().enumerate() {
        all.push((format!("people[{i}].radius"), person.radius, SIZES));
        all.push((format!("people[{i}].speed"), person.speed, SPEEDS));
    }
    all
}
