use super::rect::Rect;
use crate::dice::Dice;

/// The width of a corridor, centimetres.
const CORRIDOR: [i32; 2] = [160, 240];
/// How deep the rooms along a corridor are, centimetres.
const DEPTH: [i32; 2] = [380, 620];
/// How far a corridor goes on at least on either side of a door in it, centimetres.
const DOOR_IN_CORRIDOR: i32 = 500;

/// Where the corridors run, and the strips of floor beside them that will become rooms.
pub(super) struct Layout {
    /// They touch where they meet, and never overlap.
    pub(super) corridors: Vec<Rect>,
    pub(super) strips: Vec<Strip>,
    /// How thick inner walls are, centimetres.
    pub(super) wall: i32,
}

/// A row of rooms to be.
#[derive(Clone, Copy)]
pub(super) struct Strip {
    pub(super) rect: Rect,
    /// The axis that the rooms follow each other on.
    pub(super) along: usize,
}

impl Layout {
    /// One of the forms that office floors have, of any size and either hand.
    pub(super) fn drawn(dice: &mut Dice) -> Self {
        let wall = dice.between(5, 9) * 2;
        let mut layout = Self { corridors: Vec::new(), strips: Vec::new(), wall };
        match dice.between(1, 100) {
            ..=22 => layout.spine(dice),
            23..=62 => layout.ring(dice),
            63..=85 => layout.wings(dice, 1),
            _ => layout.wings(dice, 2),
        }
        layout.divide_corridors(dice);
        layout.turn(dice);
        layout
    }

    fn strip(&mut self, along: usize, x: [i32; 2], y: [i32; 2]) {
        self.strips.push(Strip { rect: Rect::new(x, y), along });
    }

    /// One corridor between two rows of rooms, perhaps with a room at its end.
    fn spine(&mut self, dice: &mut Dice) {
        let length = dice.between(1700, 4000);
        let ([below, above], corridor) = (depths(dice), width(dice));
        let floor = [below + self.wall, below + self.wall + corridor];
        let mut end = length;
        if dice.falls(60) {
            end -= dice.between(260, 420) + self.wall;
            self.strip(0, [end + self.wall, length], floor);
        }
        self.corridors.push(Rect::new([0, end], floor));
        self.strip(0, [0, length], [0, below]);
        self.strip(0, [0, length], [floor[1] + self.wall, floor[1] + self.wall + above]);
    }

    /// Two corridors joined by two or three others: rooms around a core, and ways around it.
    fn ring(&mut self, dice: &mut Dice) {
        let wall = self.wall;
        let [below, above] = depths(dice);
        let core = dice.between(380, 860);
        let south = [below + wall, below + wall + width(dice)];
        let inner = [south[1] + wall, south[1] + wall + core];
        let north = [inner[1] + wall, inner[1] + wall + width(dice)];
        let top = [north[1] + wall, north[1] + wall + above];
        let joints = joints(dice, wall);
        let length = joints.iter().map(|joint| joint[1]).max().unwrap_or(0) + end_room(dice, wall);
        self.corridors.extend([south, north].map(|y| Rect::new([0, length], y)));
        let mut from = 0;
        for [west, east] in joints {
            self.corridors.push(Rect::new([west, east], [south[1], north[0]]));
            self.core(dice, [from, west - wall], inner);
            from = east + wall;
        }
        self.core(dice, [from, length], inner);
        self.strip(0, [0, length], [0, below]);
        self.strip(0, [0, length], top);
    }

    /// Rooms between two corridors: as deep as the core, or back to back; at its ends, one after the
    /// other.
    fn core(&mut self, dice: &mut Dice, x: [i32; 2], y: [i32; 2]) {
        let (length, depth) = (x[1] - x[0], y[1] - y[0]);
        if length <= 0 {
            return;
        }
        if depth >= 2 * 300 + self.wall && length > 500 && dice.falls(70) {
            let middle = y[0] + dice.between(300, depth - self.wall - 300);
            self.strip(0, x, [y[0], middle]);
            self.strip(0, x, [middle + self.wall, y[1]]);
        } else {
            self.strip(usize::from(length < 700), x, y);
        }
    }

    /// A corridor with rooms on both sides, from which others lead off at right angles.
    fn wings(&mut self, dice: &mut Dice, count: i32) {
        let wall = self.wall;
        let ([below, above], corridor) = (depths(dice), width(dice));
        let floor = [0, corridor];
        self.strip(0, [0, 0], [corridor + wall, corridor + wall + above]);
        let (mut from, mut beside) = (0, 0);
        for wing in 0..count {
            let ([left, right], width) = (depths(dice), width(dice));
            // The first may stand at the end of the building: an L, where the others make a T or an F.
            let aside = if wing == 0 && dice.falls(50) { 0 } else { beside + dice.between(300, 800) };
            let west = from + aside + left + wall;
            let (east, foot) = (west + width, -below - wall - dice.between(600, 1500));
            self.corridors.push(Rect::new([west, east], [foot, 0]));
            self.strip(0, [from, west - wall], [-below - wall, -wall]);
            self.strip(1, [west - wall - left, west - wall], [foot, -below - 2 * wall]);
            self.strip(1, [east + wall, east + wall + right], [foot, -below - 2 * wall]);
            (from, beside) = (east + wall, right);
        }
        let length = from + dice.between(if count == 1 { 1000 } else { 700 }, 1400);
        self.strip(0, [from, length], [-below - wall, -wall]);
        self.strips[0].rect.high[0] = length;
        self.corridors.push(Rect::new([0, length], floor));
    }

    /// Puts a wall with room for a door across some long corridors, away from where others meet them.
    fn divide_corridors(&mut self, dice: &mut Dice) {
        for index in 0..self.corridors.len() {
            let corridor = self.corridors[index];
            let along = usize::from(corridor.size(1) > corridor.size(0));
            let [low, high] = corridor.span(along);
            if high - low < 2 * DOOR_IN_CORRIDOR || !dice.falls(35) {
                continue;
            }
            let at = dice.between(low + DOOR_IN_CORRIDOR, high - DOOR_IN_CORRIDOR);
            let near = Rect::on(along, [at - 250, at + 250], corridor.span(1 - along)).grown(1);
            let others = self.corridors.iter().enumerate().filter(|(other, _)| *other != index);
            if others.map(|(_, other)| other).all(|other| !other.overlaps(&near)) {
                self.corridors[index].high[along] = at;
                let rest = Rect::on(along, [at + self.wall, high], corridor.span(1 - along));
                self.corridors.push(rest);
            }
        }
    }

    /// Turns it to any of its eight aspects, its lowest corner at the origin.
    fn turn(&mut self, dice: &mut Dice) {
        let [swap, x, y] = [(); 3].map(|()| dice.falls(50));
        let turned = |rect: &mut Rect| *rect = rect.mirrored(swap, [x, y]);
        self.corridors.iter_mut().for_each(turned);
        for strip in &mut self.strips {
            turned(&mut strip.rect);
            strip.along = if swap { 1 - strip.along } else { strip.along };
        }
        let rects = || self.corridors.iter().chain(self.strips.iter().map(|strip| &strip.rect));
        let low = [0, 1].map(|axis| rects().map(|rect| rect.low[axis]).min().unwrap_or(0));
        let by = low.map(|low| -low);
        self.corridors.iter_mut().for_each(|rect| *rect = rect.moved(by));
        self.strips.iter_mut().for_each(|strip| strip.rect = strip.rect.moved(by));
    }
}

fn width(dice: &mut Dice) -> i32 {
    dice.between(CORRIDOR[0], CORRIDOR[1])
}

/// The depths of the rooms on two sides; often the same.
fn depths(dice: &mut Dice) -> [i32; 2] {
    let first = dice.between(DEPTH[0], DEPTH[1]);
    let second = if dice.falls(40) { first } else { dice.between(DEPTH[0], DEPTH[1]) };
    [first, second]
}

/// Where on a ring the corridors lie that join its two long ones.
fn joints(dice: &mut Dice, wall: i32) -> Vec<[i32; 2]> {
    let mut west = end_room(dice, wall);
    let mut joints = Vec::new();
    for _ in 0..if dice.falls(35) { 3 } else { 2 } {
        let east = west + width(dice);
        joints.push([west, east]);
        west = east + wall + dice.between(600, 1300) + wall;
    }
    joints
}

/// The rooms outside a ring's end with their wall, or none, so that the corridor runs along the façade.
fn end_room(dice: &mut Dice, wall: i32) -> i32 {
    if dice.falls(50) { 0 } else { dice.between(300, 520) + wall }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_overlaps_and_floors_have_the_size_of_floors() {
        for seed in 0..400 {
            let layout = Layout::drawn(&mut Dice::new(seed));
            let rects: Vec<Rect> =
                layout.corridors.iter().copied().chain(layout.strips.iter().map(|s| s.rect)).collect();
            for (i, a) in rects.iter().enumerate() {
                assert!(a.sides()[0] > 150, "seed {seed}: {a:?}");
                assert!(rects[..i].iter().all(|b| !a.overlaps(b)), "seed {seed}: {a:?}");
            }
            let size = [0, 1].map(|axis| rects.iter().map(|r| r.high[axis]).max().unwrap());
            assert!(size.iter().all(|s| (900..=4700).contains(s)), "seed {seed}: {size:?}");
        }
    }
}
