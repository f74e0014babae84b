//! A building as it is drawn on the page: a list of things, to be turned into a world file and back.

mod faults;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use cogmap_formats::world::WORLD_FORMAT;
use cogmap_simulation::{BoxObstacle, Door, Person, Post, Room, Start, World};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

pub use faults::{Checked, Fault};

/// A building that somebody is drawing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Tsify)]
#[serde(deny_unknown_fields)]
pub struct Draft {
    /// The JSON Schema that its file names.
    pub schema: Option<String>,
    /// Shown to people.
    pub name: String,
    /// One or two sentences for people.
    pub description: String,
    /// All that is in it, one of them the start.
    pub things: Vec<Thing>,
}

/// Something that stands on a sheet. Metres, and degrees counter-clockwise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Tsify)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Thing {
    /// A wall through all its corners.
    Wall {
        /// Its corners.
        points: Vec<[f64; 2]>,
    },
    /// Furniture or a carton.
    Box {
        /// Its middle.
        center: [f64; 2],
        /// Length and width.
        size: [f64; 2],
        /// Direction of its length.
        heading_deg: f64,
    },
    /// A round leg.
    Post {
        /// Its middle.
        center: [f64; 2],
        /// Metres.
        radius: f64,
    },
    /// A door; open, it stands at a right angle, counter-clockwise.
    Door {
        /// How it is called.
        name: String,
        /// The end that stays where it is.
        hinge: [f64; 2],
        /// The other end when closed.
        latch: [f64; 2],
        /// Whether it starts open.
        open: bool,
    },
    /// Somebody who walks to and fro.
    Person {
        /// The path.
        points: Vec<[f64; 2]>,
        /// Metres per second.
        speed: f64,
        /// Metres.
        radius: f64,
    },
    /// Where the robot begins.
    Start {
        /// Where it stands.
        position: [f64; 2],
        /// Where it looks.
        heading_deg: f64,
    },
    /// A way through the building, which begins after the start.
    Route {
        /// How it is called.
        name: String,
        /// The points to pass.
        points: Vec<[f64; 2]>,
    },
    /// A room as people see it.
    Room {
        /// Shown on screen.
        name: String,
        /// Its corners in order.
        points: Vec<[f64; 2]>,
    },
}

impl Draft {
    /// An empty sheet with a start.
    pub(crate) fn blank(name: String) -> Self {
        let things = vec![Thing::Start { position: [0.0, 0.0], heading_deg: 0.0 }];
        Self { schema: None, name, description: String::new(), things }
    }

    /// A world on a sheet, in the order of its file.
    pub(crate) fn of(world: World) -> Self {
        let World { walls, boxes, posts, doors, people, start, routes, rooms, .. } = world;
        let mut things: Vec<Thing> = walls.into_iter().map(|points| Thing::Wall { points }).collect();
        things.extend(boxes.into_iter().map(|BoxObstacle { center, size, heading_deg }| Thing::Box {
            center,
            size,
            heading_deg,
        }));
        things.extend(posts.into_iter().map(|Post { center, radius }| Thing::Post { center, radius }));
        things.extend(doors.into_iter().map(|Door { name, hinge, latch, open }| Thing::Door {
            name,
            hinge,
            latch,
            open,
        }));
        let person = |Person { path, speed, radius }| Thing::Person { points: path, speed, radius };
        things.extend(people.into_iter().map(person));
        things.push(Thing::Start { position: start.position, heading_deg: start.heading_deg });
        things.extend(routes.into_iter().map(|(name, points)| Thing::Route { name, points }));
        things.extend(rooms.into_iter().map(|Room { name, outline }| Thing::Room { name, points: outline }));
        Self { schema: world.schema, name: world.name, description: world.description, things }
    }

    /// The world that is drawn; of routes of the same name the last, and nothing without a start.
    pub(crate) fn world(&self) -> Option<World> {
        let mut world = self.empty_world(self.start()?);
        for thing in self.things.iter().cloned() {
            match thing {
                Thing::Wall { points } => world.walls.push(points),
                Thing::Box { center, size, heading_deg } => {
                    world.boxes.push(BoxObstacle { center, size, heading_deg });
                }
                Thing::Post { center, radius } => world.posts.push(Post { center, radius }),
                Thing::Door { name, hinge, latch, open } => {
                    world.doors.push(Door { name, hinge, latch, open });
                }
                Thing::Person { points, speed, radius } => {
                    world.people.push(Person { path: points, speed, radius });
                }
                Thing::Start { .. } => {}
                Thing::Route { name, points } => drop(world.routes.insert(name, points)),
                Thing::Room { name, points } => world.rooms.push(Room { name, outline: points }),
            }
        }
        Some(world)
    }

    fn start(&self) -> Option<Start> {
        self.things.iter().find_map(|thing| match *thing {
            Thing::Start { position, heading_deg } => Some(Start { position, heading_deg }),
            _ => None,
        })
    }

    fn empty_world(&self, start: Start) -> World {
        World {
            schema: self.schema.clone(),
            format: WORLD_FORMAT.to_owned(),
            name: self.name.clone(),
            description: self.description.clone(),
            walls: Vec::new(),
            boxes: Vec::new(),
            posts: Vec::new(),
            doors: Vec::new(),
            people: Vec::new(),
            start,
            routes: BTreeMap::new(),
            rooms: Vec::new(),
        }
    }
}

/// The name of the file that a building is saved in: what its own name has in plain letters and digits.
pub(crate) fn file_name(name: &str) -> String {
    let plain = |letter: char| if letter.is_ascii_alphanumeric() { letter.to_ascii_lowercase() } else { ' ' };
    let words: String = name.chars().map(plain).take(60).collect();
    let stem = words.split_whitespace().collect::<Vec<_>>().join("-");
    format!("{}.world.json", if stem.is_empty() { "building" } else { &stem })
}
