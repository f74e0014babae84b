use cogmap_geometry::{DVec2, Segment};
use serde::{Deserialize, Serialize};

use super::{BoxObstacle, Door, Person, World};
use crate::Disc;

/// Something that is changed in a world while a robot is in it (§3.3.1: the world keeps changing). A box
/// is called by its number: those of the world's file come first, then those set down since, in order;
/// the number of one that was taken away is not given again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "what", rename_all = "snake_case", deny_unknown_fields)]
pub enum WorldChange {
    /// Opens or closes a door.
    Door {
        /// Its name in the world.
        name: String,
        /// Whether it stands open from now on.
        open: bool,
    },
    /// Sets a box down.
    AddBox {
        /// Its middle, metres.
        center: [f64; 2],
        /// Length and width, metres.
        size: [f64; 2],
        /// Direction of its length, degrees.
        #[serde(default)]
        heading_deg: f64,
    },
    /// Moves a box.
    MoveBox {
        /// Its number.
        index: usize,
        /// Its new middle, metres.
        center: [f64; 2],
        /// The new direction of its length, degrees.
        #[serde(default)]
        heading_deg: f64,
    },
    /// Takes a box away.
    RemoveBox {
        /// Its number.
        index: usize,
    },
    /// Lets somebody come who walks to and fro.
    AddPerson(Person),
    /// Makes the robot's errors larger or smaller from now on.
    Noise(Noise),
}

/// How large the errors of a robot's measuring are, in multiples of its own: worn wheels or a smooth floor, a dusty
/// lens.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Noise {
    /// Those of its odometry: unequal wheels, wrong axle, slip.
    pub odometry: f64,
    /// Those of its laser's ranges: noise and bias.
    pub laser: f64,
}

impl Default for Noise {
    fn default() -> Self {
        Self { odometry: 1.0, laser: 1.0 }
    }
}

/// Errors grow to no more than so many times a robot's own.
const NOISE_MAX: f64 = 100.0;
/// No box is shorter or longer, metres.
const SIZES: [f64; 2] = [0.01, 100.0];
/// Nothing is set down farther from the origin, metres.
pub(crate) const COORDINATE_MAX: f64 = 10_000.0;
/// How many boxes may be set down in one run.
const ADDED_MAX: usize = 1000;

/// A world that can be changed, and its boxes by their numbers.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ChangingWorld {
    /// As it is now.
    pub(crate) world: World,
    /// By number; `None` where it was taken away.
    pub(crate) boxes: Vec<Option<BoxObstacle>>,
    /// How many of them are the world file's.
    pub(crate) from_file: usize,
    /// What the robot's measuring is like.
    pub(crate) noise: Noise,
}

impl ChangingWorld {
    pub(crate) fn new(world: &World) -> Self {
        let boxes: Vec<_> = world.boxes.iter().cloned().map(Some).collect();
        Self { world: world.clone(), from_file: boxes.len(), boxes, noise: Noise::default() }
    }

    /// The world after a change, and what it makes stand where it did not; `None` where all is so already.
    /// An error says what speaks against it.
    pub(crate) fn after(&self, change: &WorldChange) -> Result<Option<(Self, New)>, String> {
        let mut next = self.clone();
        let new = match change {
            WorldChange::Door { name, open } => {
                let door = next.world.doors.iter_mut().find(|door| door.name == *name);
                let door = door.ok_or_else(|| self.no_door(name))?;
                door.open = *open;
                New::Leaf(door.faces())
            }
            WorldChange::AddBox { center, size, heading_deg } => {
                let carton = BoxObstacle { center: *center, size: *size, heading_deg: *heading_deg };
                if next.boxes.len() >= next.from_file + ADDED_MAX {
                    return Err(format!("{ADDED_MAX} boxes have been set down already"));
                }
                next.boxes.push(Some(checked(carton.clone())?));
                New::Box(carton)
            }
            WorldChange::MoveBox { index, center, heading_deg } => {
                let size = self.standing(*index)?.size;
                let carton = BoxObstacle { center: *center, size, heading_deg: *heading_deg };
                next.boxes[*index] = Some(checked(carton.clone())?);
                New::Box(carton)
            }
            WorldChange::RemoveBox { index } => {
                self.standing(*index)?;
                next.boxes[*index] = None;
                New::Nothing
            }
            WorldChange::AddPerson(person) => {
                next.world.people.push(walking(person.clone())?);
                New::Feet(Disc { center: person.path[0].into(), radius: person.radius })
            }
            WorldChange::Noise(noise) => {
                next.noise = bearable(*noise)?;
                New::Nothing
            }
        };
        next.world.boxes = next.boxes.iter().flatten().cloned().collect();
        Ok((next != *self).then_some((next, new)))
    }

    fn standing(&self, index: usize) -> Result<&BoxObstacle, String> {
        self.boxes.get(index).and_then(Option::as_ref).ok_or_else(|| format!("there is no box {index}"))
    }

    fn no_door(&self, name: &str) -> String {
        let doors: Vec<&str> = self.world.doors.iter().map(|Door { name, .. }| name.as_str()).collect();
        let known = if doors.is_empty() { "this world has none".to_owned() } else { doors.join(", ") };
        format!("there is no door `{name}`: {known}")
    }
}

/// A box that can be simulated.
fn checked(carton: BoxObstacle) -> Result<BoxObstacle, String> {
    let within = |value: f64, [low, high]: [f64; 2]| (low..=high).contains(&value);
    let sized = carton.size.iter().all(|&side| within(side, SIZES));
    let placed = [carton.center[0], carton.center[1], carton.heading_deg];
    if !sized {
        return Err(format!("a box is {} to {} m long and wide", SIZES[0], SIZES[1]));
    }
    if !placed.iter().all(|&value| within(value, [-COORDINATE_MAX, COORDINATE_MAX])) {
        return Err(format!("a box stands at most {COORDINATE_MAX} m from the origin"));
    }
    Ok(carton)
}

/// Errors that can be simulated.
fn bearable(noise: Noise) -> Result<Noise, String> {
    let all = [noise.odometry, noise.laser].iter().all(|times| (0.0..=NOISE_MAX).contains(times));
    if all { Ok(noise) } else { Err(format!("errors are 0 to {NOISE_MAX} times the robot's own")) }
}

/// Somebody who can be simulated.
fn walking(person: Person) -> Result<Person, String> {
    let near = |value: &f64| value.abs() <= COORDINATE_MAX;
    if person.path.is_empty() || !person.path.iter().flatten().all(near) {
        return Err(format!("somebody walks along points at most {COORDINATE_MAX} m from the origin"));
    }
    if !(0.0..=5.0).contains(&person.speed) || !(SIZES[0]..=1.0).contains(&person.radius) {
        return Err("somebody walks at most 5 m a second and is at most 1 m around".to_owned());
    }
    Ok(person)
}

/// What a change makes stand where nothing stood.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum New {
    Nothing,
    Feet(Disc),
    Leaf([Segment; 4]),
    Box(BoxObstacle),
}

impl New {
    /// Whether it would stand on a disc, such as a robot or somebody's feet.
    pub(crate) fn meets(&self, center: DVec2, radius: f64) -> bool {
        match self {
            Self::Nothing => false,
            Self::Feet(feet) => feet.center.distance(center) < feet.radius + radius,
            Self::Leaf(faces) => faces.iter().any(|face| face.distance_to(center) < radius),
            Self::Box(carton) => {
                carton.contains(center) || carton.edges().iter().any(|edge| edge.distance_to(center) < radius)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hall() -> ChangingWorld {
        let text = r#"{ "format": "cogmap-world/1", "name": "Hall", "start": {"position": [0, 0]},
            "walls": [[[-3,-3],[3,-3]]], "boxes": [{"center": [2,2], "size": [0.5,0.5]}],
            "doors": [{"name": "d", "hinge": [1,0], "latch": [2,0], "open": true}] }"#;
        ChangingWorld::new(&serde_json::from_str(text).unwrap())
    }

    fn after(hall: &ChangingWorld, change: &str) -> Result<ChangingWorld, String> {
        let change = serde_json::from_str(change).unwrap();
        hall.after(&change).map(|next| next.map_or_else(|| hall.clone(), |(next, _)| next))
    }

    #[test]
    fn a_door_closes_and_closing_it_again_changes_nothing() {
        let close = r#"{"what": "door", "name": "d", "open": false}"#;
        let closed = after(&hall(), close).unwrap();
        assert_eq!(closed.world.doors[0].leaf().b, DVec2::new(2.0, 0.0));
        assert_eq!(closed.after(&serde_json::from_str(close).unwrap()), Ok(None));
    }

    #[test]
    fn a_box_keeps_its_number_whatever_becomes_of_the_others() {
        let hall = after(&hall(), r#"{"what": "add_box", "center": [0,1], "size": [0.4,0.3]}"#).unwrap();
        let hall = after(&hall, r#"{"what": "remove_box", "index": 0}"#).unwrap();
        let hall = after(&hall, r#"{"what": "move_box", "index": 1, "center": [0,2]}"#).unwrap();
        assert_eq!(hall.boxes[0], None);
        assert_eq!(hall.world.boxes.len(), 1);
        assert_eq!((hall.world.boxes[0].center, hall.world.boxes[0].size), ([0.0, 2.0], [0.4, 0.3]));
    }

    #[test]
    fn what_cannot_be_is_refused_with_a_reason() {
        for (change, reason) in [
            (r#"{"what": "door", "name": "e", "open": true}"#, "no door `e`: d"),
            (r#"{"what": "move_box", "index": 1, "center": [0,0]}"#, "no box 1"),
            (r#"{"what": "remove_box", "index": 9}"#, "no box 9"),
            (r#"{"what": "add_box", "center": [0,0], "size": [0,1]}"#, "0.01 to 100 m"),
            (r#"{"what": "add_box", "center": [1e9,0], "size": [1,1]}"#, "from the origin"),
            (r#"{"what": "noise", "odometry": -1}"#, "0 to 100 times"),
        ] {
            let error = after(&hall(), change).unwrap_err();
            assert!(error.contains(reason), "{error}");
        }
    }
}
