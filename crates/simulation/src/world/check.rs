use std::collections::BTreeSet;

use super::{World, numbers, reach};

/// How many pieces of wall, box edges, faces of doors and posts a world may have.
const SOLIDS_MAX: usize = 100_000;
/// How many points all routes of a world may have together.
const ROUTE_POINTS_MAX: usize = 10_000;

/// Something in a file that cannot be simulated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Where in the file, such as `boxes[3].size`.
    pub place: String,
    /// What was expected, what is there, and what to do.
    pub message: String,
}

impl Problem {
    pub(crate) fn new(place: impl Into<String>, message: impl Into<String>) -> Self {
        Self { place: place.into(), message: message.into() }
    }
}

impl World {
    /// Everything about this world that could not be simulated, each with the way out. Where the
    /// robot stands and where its routes lead is looked at only when the rest is in order.
    #[must_use]
    pub fn problems(&self) -> Vec<Problem> {
        let mut problems = self.wrong_format();
        problems.extend(self.too_large());
        if problems.is_empty() {
            problems = numbers::problems(self);
            problems.extend(self.too_short());
            problems.extend(self.names_used_twice());
        }
        if problems.is_empty() { reach::problems(self) } else { problems }
    }

    fn wrong_format(&self) -> Vec<Problem> {
        if self.format == "cogmap-world/1" {
            return Vec::new();
        }
        let message =
            format!("expected \"cogmap-world/1\", found {:?}: this program reads no other", self.format);
        vec![Problem::new("format", message)]
    }

    fn too_large(&self) -> Vec<Problem> {
        let walls: usize = self.walls.iter().map(|wall| wall.len().saturating_sub(1)).sum();
        let four_sided = 4 * (self.boxes.len() + self.doors.len());
        let solids = walls + four_sided + self.posts.len() + self.people.len();
        let points = self.routes.values().map(Vec::len).sum::<usize>();
        let corners = self.rooms.iter().map(|room| room.outline.len()).sum::<usize>();
        let counted = [
            ("walls", solids, SOLIDS_MAX, "solids", "merge short pieces of wall"),
            ("routes", points, ROUTE_POINTS_MAX, "points", "leave points out"),
            ("rooms", corners, SOLIDS_MAX, "corners", "simplify the outlines"),
        ];
        let over = counted.into_iter().filter(|&(_, count, most, ..)| count > most);
        let problem = |(place, count, most, what, way_out): (&str, usize, usize, &str, &str)| {
            Problem::new(
                place,
                format!("there are {count} {what}, and at most {most} are allowed: {way_out}"),
            )
        };
        over.map(problem).collect()
    }

    fn too_short(&self) -> Vec<Problem> {
        let mut problems = Vec::new();
        let mut demand = |place: String, found: usize, least: usize, what: &str| {
            if found < least {
                let message =
                    format!("expected at least {least} {what}, found {found}: add some or remove it");
                problems.push(Problem::new(place, message));
            }
        };
        for (i, wall) in self.walls.iter().enumerate() {
            demand(format!("walls[{i}]"), wall.len(), 2, "points");
        }
        for (i, person) in self.people.iter().enumerate() {
            demand(format!("people[{i}].path"), person.path.len(), 1, "point");
        }
        for (name, route) in &self.routes {
            demand(format!("routes.{name}"), route.len(), 1, "point");
        }
        for (i, room) in self.rooms.iter().enumerate() {
            demand(format!("rooms[{i}].outline"), room.outline.len(), 3, "corners");
        }
        problems.extend(self.walls_without_length());
        problems
    }

    fn walls_without_length(&self) -> impl Iterator<Item = Problem> + '_ {
        let repeated = |wall: &Vec<[f64; 2]>| wall.windows(2).position(|ends| ends.first() == ends.last());
        let walls = self.walls.iter().enumerate().filter_map(move |(i, wall)| Some((i, repeated(wall)? + 1)));
        let walls = walls.map(|(i, k)| {
            Problem::new(
                format!("walls[{i}][{k}]"),
                "is the same point as the one before: remove one of them",
            )
        });
        let doors = self.doors.iter().enumerate().filter(|(_, door)| door.hinge == door.latch);
        walls.chain(doors.map(|(i, _)| {
            Problem::new(
                format!("doors[{i}].latch"),
                "is the same point as the hinge: move it a door's width away",
            )
        }))
    }

    fn names_used_twice(&self) -> Vec<Problem> {
        let mut names = BTreeSet::new();
        let again = self.doors.iter().enumerate().filter(|(_, door)| !names.insert(door.name.as_str()));
        let problem = |(i, door): (usize, &super::Door)| {
            let message = format!("another door is called {:?} too: give each its own name", door.name);
            Problem::new(format!("doors[{i}].name"), message)
        };
        again.map(problem).collect()
    }
}

#[cfg(test)]
mod tests;
