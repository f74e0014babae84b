//! Office floors that nobody drew: any number of them, each the same for the same seed everywhere.
//!
//! The rooms follow the making of a floor: [`layout`] runs corridors, [`space`] divides the strips
//! beside them into rooms, [`doorway`] lets people through the walls, [`furniture`] fills each [`room`]
//! with [`piece`]s, [`outline`] draws the walls, and [`outing`] takes a robot somewhere. All of it is ours. Lengths are whole centimetres until the last moment, so that walls meet.

mod doorway;
mod furniture;
mod layout;
mod outing;
mod outline;
mod piece;
mod rect;
mod room;
mod space;

use doorway::Doorway;
use layout::Layout;
use outing::Outing;
use rect::{Rect, metres};
use space::{Kind, Space};

use crate::{Room, Start, World, dice::Dice};

/// How thick outer walls are, centimetres.
const OUTER_WALL: i32 = 30;
/// A shaft or a court of less than this area inside the walls is not worth a line, square metres.
const CHINK: f64 = 0.5;

/// The name of the way out.
const OUT: &str = "out";

/// An office floor.
pub struct Building {
    spaces: Vec<Space>,
    doorways: Vec<Doorway>,
    /// Where windows stand back in the outer wall.
    recesses: Vec<Rect>,
}

impl Building {
    /// The floor of a seed, furnished, with a start and a way out, `out`.
    #[must_use]
    pub fn generate(seed: u64) -> World {
        let mut dice = Dice::new(seed);
        let building = Self::drawn(&mut dice);
        let mut world = building.world(seed);
        (world.boxes, world.posts) = furniture::furnish(&building, &mut dice);
        if let Some(outing) = Outing::drawn(&building, &world, &mut dice) {
            world.start = outing.start;
            world.routes.insert(OUT.to_owned(), outing.route);
        }
        world
    }

    fn drawn(dice: &mut Dice) -> Self {
        let layout = Layout::drawn(dice);
        let mut spaces = space::spaces(&layout, dice);
        let mut doorways = doorway::connect(&mut spaces, layout.wall, dice);
        space::name_all(&mut spaces);
        doorway::name_all(&mut doorways, &spaces);
        let mut building = Self { spaces, doorways, recesses: Vec::new() };
        building.recess_windows(dice);
        building
    }

    /// Sets windows back into the outer walls of some rooms, as deep as the building has it.
    fn recess_windows(&mut self, dice: &mut Dice) {
        let (deep, wide, apart) = (dice.between(8, 16), dice.between(90, 190), dice.between(40, 120));
        if dice.falls(25) {
            return;
        }
        for space in &self.spaces {
            for axis in [0, 1] {
                let [low, high] = space.rect.span(axis);
                let count = (high - low - 40 + apart) / (wide + apart);
                let first = low + (high - low - count * (wide + apart) + apart) / 2;
                let [bottom, top] = space.rect.span(1 - axis);
                for (window, side) in
                    (0..count).flat_map(|k| [(k, [bottom - deep, bottom]), (k, [top, top + deep])])
                {
                    let from = first + window * (wide + apart);
                    let recess = Rect::on(axis, [from, from + wide], side);
                    let near = recess.grown(OUTER_WALL);
                    let others = self.spaces.iter().filter(|other| other.rect != space.rect);
                    if others.into_iter().all(|other| !other.rect.overlaps(&near)) {
                        self.recesses.push(recess);
                    }
                }
            }
        }
    }

    fn world(&self, seed: u64) -> World {
        World {
            schema: None,
            format: "cogmap-world/1".to_owned(),
            name: format!("Office floor {seed}"),
            description: self.description(),
            walls: self.walls(),
            boxes: Vec::new(),
            posts: Vec::new(),
            doors: self.doorways.iter().filter_map(|doorway| doorway.leaf.clone()).collect(),
            people: Vec::new(),
            start: Start { position: metres(self.spaces[0].rect.low.map(|c| c + 80)), heading_deg: 0.0 },
            routes: std::collections::BTreeMap::new(),
            rooms: self.spaces.iter().map(room).collect(),
        }
    }

    fn description(&self) -> String {
        let corridors = self.spaces.iter().filter(|space| space.kind == Kind::Corridor).count();
        let rooms = self.spaces.len() - corridors;
        let doors = self.doorways.iter().filter(|doorway| doorway.leaf.is_some()).count();
        format!("Made from a seed: {rooms} rooms and {doors} doors along {corridors} stretches of corridor.")
    }

    fn walls(&self) -> Vec<Vec<[f64; 2]>> {
        let mut floor: Vec<Rect> = self.spaces.iter().map(|space| space.rect).collect();
        floor.extend(self.doorways.iter().map(|doorway| doorway.opening));
        let outside: Vec<Rect> = floor.iter().map(|rect| rect.grown(OUTER_WALL)).collect();
        floor.extend(&self.recesses);
        let facades = outline::outlines(&outside).into_iter().filter(|line| area(line).abs() > CHINK);
        facades.chain(outline::outlines(&floor)).map(|line| line.into_iter().map(metres).collect()).collect()
    }
}

/// Square metres inside a closed line that turns left.
fn area(line: &[[i32; 2]]) -> f64 {
    let pairs = line.iter().zip(line.iter().skip(1)).map(|(a, b)| [*a, *b].map(metres));
    pairs.map(|[a, b]| (a[0] * b[1] - b[0] * a[1]) / 2.0).sum()
}

fn room(space: &Space) -> Room {
    let Rect { low: [x, y], high: [x2, y2] } = space.rect;
    Room { name: space.name.clone(), outline: [[x, y], [x2, y], [x2, y2], [x, y2]].map(metres).to_vec() }
}

#[cfg(test)]
mod tests;
