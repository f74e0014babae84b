use cogmap_geometry::Pose;
use cogmap_mapping::perception::Scan;
use rand_pcg::Pcg64Mcg;

use crate::{
    BoxObstacle, Disc, Laser, Noise, Obstacles, RayGrid, Robot, Solids, World, WorldChange,
    world::{ChangingWorld, New},
};

/// What does not move by itself: the building as it is now, and what the robot is like.
pub(super) struct Stage {
    changing: ChangingWorld,
    robot: Robot,
    laser: Laser,
    /// The laser with the errors that it has now.
    eye: Laser,
    solids: Solids,
    obstacles: Obstacles,
    grid: RayGrid,
    changes: usize,
}

impl Stage {
    pub(super) fn new(world: &World, robot: &Robot, laser: Laser) -> Self {
        Self::arranged(ChangingWorld::new(world), robot.clone(), laser, 0)
    }

    fn arranged(changing: ChangingWorld, robot: Robot, laser: Laser, changes: usize) -> Self {
        let solids = Solids::numbered(&changing.world, &changing.boxes, changing.from_file);
        Self {
            grid: RayGrid::new(&solids.segments, &solids.discs),
            obstacles: Obstacles::new(&solids),
            solids,
            eye: laser.noisier(changing.noise.laser),
            changing,
            robot,
            laser,
            changes,
        }
    }

    /// The building after a change, if that changes anything; an error says what speaks against it.
    pub(super) fn after(&self, change: &WorldChange, bodies: Bodies<'_>) -> Result<Option<Self>, String> {
        let Some((next, new)) = self.changing.after(change)? else { return Ok(None) };
        bodies.make_way_for(&new)?;
        Ok(Some(Self::arranged(next, self.robot.clone(), self.laser.clone(), self.changes + 1)))
    }

    /// One sweep of the laser, and what each beam truly hit.
    pub(super) fn scan(&self, at: Pose, people: &[Disc], rng: &mut Pcg64Mcg) -> (Scan, Vec<Option<u32>>) {
        self.eye.scan_among((&self.grid, &self.solids.added, people), at, rng)
    }

    pub(super) fn world(&self) -> &World {
        &self.changing.world
    }

    pub(super) fn boxes(&self) -> &[Option<BoxObstacle>] {
        &self.changing.boxes
    }

    pub(super) fn robot(&self) -> &Robot {
        &self.robot
    }

    /// How large the robot's errors are now, in multiples of its own.
    pub(super) fn noise(&self) -> Noise {
        self.changing.noise
    }

    pub(super) fn solids(&self) -> &Solids {
        &self.solids
    }

    pub(super) fn obstacles(&self) -> &Obstacles {
        &self.obstacles
    }

    /// How many changes there were.
    pub(super) fn changes(&self) -> usize {
        self.changes
    }
}

/// Those who stand where something might be set down.
#[derive(Clone, Copy)]
pub(super) struct Bodies<'a> {
    pub(super) robot: Disc,
    pub(super) people: &'a [Disc],
}

impl Bodies<'_> {
    fn make_way_for(&self, new: &New) -> Result<(), String> {
        if new.meets(self.robot.center, self.robot.radius) {
            return Err("the robot stands there".to_owned());
        }
        match self.people.iter().any(|person| new.meets(person.center, person.radius)) {
            true => Err("somebody stands there".to_owned()),
            false => Ok(()),
        }
    }
}
