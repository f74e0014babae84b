use std::collections::BTreeSet;

use cogmap_geometry::DVec2;

use super::{Problem, World};
use crate::BodyParams;

impl World {
    /// What can be simulated and yet is hardly what its author meant, each with what to do. None of it
    /// keeps anybody from using the world.
    #[must_use]
    pub fn remarks(&self) -> Vec<Problem> {
        let mut remarks = self.without_names();
        remarks.extend(self.rooms_of_one_name());
        remarks.extend(self.narrow_doors());
        remarks.extend(self.crossed_outlines());
        remarks
    }

    fn without_names(&self) -> Vec<Problem> {
        let doors = self.doors.iter().enumerate().map(|(i, door)| (format!("doors[{i}].name"), &door.name));
        let rooms = self.rooms.iter().enumerate().map(|(i, room)| (format!("rooms[{i}].name"), &room.name));
        let routes = self.routes.keys().map(|name| (format!("routes.{name}"), name));
        let world = [("name".to_owned(), &self.name)];
        let named = world.into_iter().chain(doors).chain(rooms).chain(routes);
        let nameless = named.filter(|(_, name)| name.trim().is_empty());
        nameless.map(|(place, _)| Problem::new(place, "is empty: give it a name")).collect()
    }

    fn rooms_of_one_name(&self) -> Vec<Problem> {
        let mut names = BTreeSet::new();
        let rooms = self.rooms.iter().enumerate().filter(|(_, room)| !room.name.trim().is_empty());
        let again = rooms.filter(|(_, room)| !names.insert(room.name.as_str()));
        let remark = |(i, room): (usize, &super::Room)| {
            let message = format!("another room is called {:?} too: nobody can tell them apart", room.name);
            Problem::new(format!("rooms[{i}].name"), message)
        };
        again.map(remark).collect()
    }

    fn narrow_doors(&self) -> Vec<Problem> {
        let robot = 2.0 * BodyParams::default().radius;
        let width = |door: &super::Door| DVec2::from(door.hinge).distance(door.latch.into());
        let doors = self.doors.iter().map(width).enumerate().filter(|&(_, width)| width < robot);
        let remark = |(i, width): (usize, f64)| {
            let message = format!("is {width:.2} m wide, and the robot is {robot} m: widen the door");
            Problem::new(format!("doors[{i}]"), message)
        };
        doors.map(remark).collect()
    }

    fn crossed_outlines(&self) -> Vec<Problem> {
        let rooms = self.rooms.iter().enumerate().filter(|(_, room)| crosses_itself(&room.outline));
        let remark = |(i, _)| {
            Problem::new(
                format!("rooms[{i}].outline"),
                "crosses itself: list the corners in the order in which somebody walks round the room",
            )
        };
        rooms.map(remark).collect()
    }
}

/// An outline with more corners than this is not looked through: none that a person draws has.
const CORNERS_MAX: usize = 500;

/// Whether two sides of an outline that do not follow each other cross.
fn crosses_itself(outline: &[[f64; 2]]) -> bool {
    let corners: Vec<DVec2> = outline.iter().copied().map(DVec2::from).collect();
    let next = corners.iter().cycle().skip(1);
    let sides: Vec<_> = corners.iter().copied().zip(next.copied()).collect();
    let cross = |i: usize, j: usize| sides.get(i).zip(sides.get(j)).is_some_and(|(a, b)| properly(*a, *b));
    sides.len() <= CORNERS_MAX && (0..sides.len()).any(|i| (i + 2..sides.len()).any(|j| cross(i, j)))
}

/// Whether two sides cross at a point that is an end of neither.
fn properly((a, b): (DVec2, DVec2), (c, d): (DVec2, DVec2)) -> bool {
    let beside = |from: DVec2, to: DVec2, point: DVec2| (to - from).perp_dot(point - from);
    beside(a, b, c) * beside(a, b, d) < 0.0 && beside(c, d, a) * beside(c, d, b) < 0.0
}

#[cfg(test)]
mod tests {
    use crate::World;

    fn remarks(added: &str) -> Vec<String> {
        let text = format!(
            r#"{{"format": "cogmap-world/1", "name": "test", "start": {{"position": [1,1]}},
                "walls": [[[0,0],[8,0],[8,6],[0,6],[0,0]]], {added}}}"#
        );
        let world: World = serde_json::from_str(&text).unwrap();
        assert_eq!(world.problems(), [], "{added}");
        world.remarks().into_iter().map(|remark| remark.place).collect()
    }

    #[test]
    fn what_is_hardly_meant_is_told_where_it_is_and_stops_nothing() {
        for (added, place) in [
            (r#""doors": [{"name": " ", "hinge": [4,3], "latch": [4,4]}]"#, "doors[0].name"),
            (r#""doors": [{"name": "d", "hinge": [4,3], "latch": [4.3,3.3]}]"#, "doors[0]"),
            (r#""rooms": [{"name": "", "outline": [[0,0],[1,0],[1,1]]}]"#, "rooms[0].name"),
            (r#""rooms": [{"name": "r", "outline": [[0,0],[2,2],[2,0],[0,2]]}]"#, "rooms[0].outline"),
            (
                r#""rooms": [{"name": "r", "outline": [[0,0],[1,0],[1,1]]}, {"name": "r", "outline": [[3,0],[4,0],[4,1]]}]"#,
                "rooms[1].name",
            ),
            (r#""routes": {"": [[3,1]]}"#, "routes."),
        ] {
            assert_eq!(remarks(added), [place], "{added}");
        }
    }

    #[test]
    fn outlines_that_touch_themselves_and_wide_doors_are_as_they_should_be() {
        let bent = r#""rooms": [{"name": "r", "outline": [[0,0],[6,0],[6,2],[1,2],[1,5],[0,5]]}],
            "doors": [{"name": "d", "hinge": [4,3], "latch": [4.5,3]}]"#;
        assert_eq!(remarks(bent), [""; 0]);
    }
}
