//! Tasks for a robot that is to find home: a building, a way out, and what happens behind its back.

use cogmap_geometry::DVec2;

use crate::{Door, World, WorldChange, dice::Dice, driver::Planner};

mod cartons;
mod people;
mod reach;

use reach::Reach;

/// What an episode does to a building, and when. Each is ours; the thesis names the dangers (§3.3.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Setting {
    /// Nothing but walls and doors.
    Empty,
    /// As the building is.
    Furnished,
    /// Cartons are put down on the way that the robot came; another way home or enough room is left.
    BoxesDropped,
    /// A door that it came through is closed behind it; another way exists.
    DoorClosed,
    /// The same, and no other way exists: home cannot be reached.
    NoWay,
    /// Furniture near its way is moved onto it; a way home is left.
    BoxesMoved,
    /// From the beginning cartons stand densely on both sides of a stretch of the way, 0.75 to 0.9 m apart.
    Narrow,
    /// When the robot is told to go home, people begin to walk across the way and along it.
    People,
}

/// A task: a way out, and a command to go home at its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Episode {
    /// The building as the robot first meets it.
    pub world: World,
    /// The way out: points after the start, metres.
    pub route: Vec<DVec2>,
    /// What is changed between the end of the way out and the command to go home.
    pub changes: Vec<WorldChange>,
}

impl Setting {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Empty,
        Self::Furnished,
        Self::BoxesDropped,
        Self::DoorClosed,
        Self::NoWay,
        Self::BoxesMoved,
        Self::Narrow,
        Self::People,
    ];

    /// How it is called in tables and on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Empty => "empty",
            Self::Furnished => "furnished",
            Self::BoxesDropped => "boxes-dropped",
            Self::DoorClosed => "door-closed",
            Self::NoWay => "no-way",
            Self::BoxesMoved => "boxes-moved",
            Self::Narrow => "narrow",
            Self::People => "people",
        }
    }

    /// The setting of that name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|setting| setting.name() == name)
    }

    /// Whether everything that is special about it happens after the way out, so that this can be shared
    /// with [`Setting::Furnished`].
    #[must_use]
    pub fn begins_furnished(self) -> bool {
        !matches!(self, Self::Empty | Self::Narrow)
    }
}

impl Episode {
    /// A setting in a world with a way out: the same for the same seed. `None` where the world has no
    /// place for it, such as a door that the way leads through.
    ///
    /// ```
    /// use cogmap_simulation::{Building, Episode, Setting};
    /// let world = Building::generate(7);
    /// let route: Vec<_> = world.routes["out"].iter().map(|&point| point.into()).collect();
    /// let episode = Episode::new(&world, &route, Setting::Empty, 7).unwrap();
    /// assert!(episode.world.boxes.is_empty() && episode.changes.is_empty());
    /// ```
    #[must_use]
    pub fn new(world: &World, route: &[DVec2], setting: Setting, seed: u64) -> Option<Self> {
        let stream = Setting::ALL.iter().position(|other| *other == setting)? as u64 + 1;
        let mut dice = Dice::new(seed.wrapping_mul(16).wrapping_add(stream));
        let mut episode = Self { world: world.clone(), route: route.to_vec(), changes: Vec::new() };
        let (world, changes) = (&mut episode.world, &mut episode.changes);
        match setting {
            Setting::Empty if world.boxes.is_empty() && world.posts.is_empty() => return None,
            Setting::Empty => {
                world.boxes.clear();
                world.posts.clear();
            }
            Setting::Furnished => {}
            Setting::BoxesDropped => *changes = cartons::dropped(world, route, &mut dice)?,
            Setting::DoorClosed => changes.push(closed(world, route, true, &mut dice)?),
            Setting::NoWay => changes.push(closed(world, route, false, &mut dice)?),
            Setting::BoxesMoved => *changes = cartons::moved(world, route, &mut dice)?,
            Setting::Narrow => world.boxes.extend(cartons::course(world, route, &mut dice)?),
            Setting::People => *changes = people::crossing(world, route, &mut dice)?,
        }
        Some(episode)
    }

    /// The building as it is when the robot is told to go home.
    #[must_use]
    pub fn world_at_command(&self) -> World {
        let mut world = self.world.clone();
        self.changes.iter().for_each(|change| apply(&mut world, change));
        world
    }
}

/// What a change makes of a world; numbers of boxes are those of the world as it was.
fn apply(world: &mut World, change: &WorldChange) {
    match change {
        WorldChange::Door { name, open } => {
            world.doors.iter_mut().filter(|door| door.name == *name).for_each(|door| door.open = *open);
        }
        WorldChange::AddBox { center, size, heading_deg } => {
            let carton = crate::BoxObstacle { center: *center, size: *size, heading_deg: *heading_deg };
            world.boxes.push(carton);
        }
        WorldChange::MoveBox { index, center, heading_deg } => {
            if let Some(carton) = world.boxes.get_mut(*index) {
                (carton.center, carton.heading_deg) = (*center, *heading_deg);
            }
        }
        WorldChange::AddPerson(person) => world.people.push(person.clone()),
        WorldChange::RemoveBox { .. } | WorldChange::Noise(_) => {}
    }
}

/// Closes one of the open doors that the way leads through, so that a way home is left, or none.
fn closed(world: &World, route: &[DVec2], way_left: bool, dice: &mut Dice) -> Option<WorldChange> {
    let start = world.start.position.into();
    let end = *route.last()?;
    let open = world.doors.iter().filter(|door| door.open && reach::leads_through(start, route, door));
    let far = open.filter(|door| [start, end].iter().all(|&spot| swing_distance(door, spot) > 0.6));
    let doors = dice.shuffled(far.collect::<Vec<&Door>>());
    doors.into_iter().find_map(|door| {
        let change = WorldChange::Door { name: door.name.clone(), open: false };
        let mut after = world.clone();
        apply(&mut after, &change);
        let is_left = if way_left {
            Reach::AMPLE.leads(&after, end, start)
        } else {
            Reach::SCANT.leads(&after, end, start)
        };
        (is_left == way_left).then_some(change)
    })
}

/// How far a spot is from where a door's leaf stands, open or closed.
fn swing_distance(door: &Door, spot: DVec2) -> f64 {
    let [open, closed] = [true, false].map(|open| Door { open, ..door.clone() }.leaf());
    open.distance_to(spot).min(closed.distance_to(spot))
}

/// Whether a planner can be made for a world at all.
fn planner(world: &World, radius: f64) -> Planner {
    Planner::new(world, &[], radius)
}

#[cfg(test)]
mod tests;
