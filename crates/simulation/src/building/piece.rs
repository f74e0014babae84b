use cogmap_geometry::{DVec2, trig};

use crate::{BoxObstacle, Post, dice::Dice};

/// A piece of furniture as the laser meets it, its back in the middle of its wall: x along the wall, y
/// into the room, metres.
#[derive(Clone, Default)]
pub(super) struct Piece {
    /// What it takes along the wall and into the room, with whoever uses it.
    pub(super) size: DVec2,
    pub(super) boxes: Vec<BoxObstacle>,
    pub(super) posts: Vec<Post>,
}

/// Radius of a table's leg and of a castor, metres.
const LEG: f64 = 0.025;
/// Radius of a chair's leg, metres.
const THIN: f64 = 0.015;

impl Piece {
    /// A solid piece that stands against its wall.
    pub(super) fn solid(along: f64, deep: f64) -> Self {
        let mut piece = Self::taking(along, deep);
        piece.solid_at([0.0, deep / 2.0], [along, deep]);
        piece
    }

    fn taking(along: f64, deep: f64) -> Self {
        Self { size: DVec2::new(along, deep), ..Self::default() }
    }

    fn solid_at(&mut self, center: [f64; 2], size: [f64; 2]) {
        self.boxes.push(BoxObstacle { center, size, heading_deg: 0.0 });
    }

    fn post(&mut self, center: [f64; 2], radius: f64) {
        self.posts.push(Post { center, radius });
    }

    fn legs(&mut self, [x, y]: [f64; 2], [along, deep]: [f64; 2], radius: f64) {
        for (sx, sy) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            self.post([x + sx * along / 2.0, y + sy * deep / 2.0], radius);
        }
    }

    /// A desk with drawers and a panel at its back, and its chair.
    pub(super) fn desk(dice: &mut Dice) -> Self {
        let mut piece = Self::taking(dice.pick(&[1.4, 1.6, 1.8]).unwrap_or(1.6), 1.45);
        piece.desk_at(0.0, 1.0, dice);
        piece
    }

    /// Desks in two rows, face to face.
    pub(super) fn island(pairs: i32, dice: &mut Dice) -> Self {
        let along = 1.6 * f64::from(pairs);
        let mut piece = Self::taking(along, 2.9);
        for pair in 0..pairs {
            let x = 1.6 * (f64::from(pair) + 0.5) - along / 2.0;
            for side in [-1.0, 1.0] {
                let mut desk = Self::taking(1.6, 1.45);
                desk.desk_at(0.0, 1.0, dice);
                piece.take_in(&desk, x, side);
            }
        }
        piece
    }

    /// Adds a piece, turned to one side or the other of the line 1.45 m into the room.
    fn take_in(&mut self, other: &Self, x: f64, side: f64) {
        let turned = |[px, py]: [f64; 2]| [x + side * px, 1.45 + side * py];
        self.boxes.extend(other.boxes.iter().map(|b| BoxObstacle { center: turned(b.center), ..*b }));
        self.posts.extend(other.posts.iter().map(|p| Post { center: turned(p.center), ..*p }));
    }

    fn desk_at(&mut self, x: f64, hand: f64, dice: &mut Dice) {
        let (along, deep) = (self.size.x.min(1.8), 0.75);
        if dice.falls(18) {
            self.solid_at([x, deep / 2.0], [along, deep]);
        } else {
            let hand = if dice.falls(50) { hand } else { -hand };
            self.solid_at([x + hand * (along / 2.0 - 0.27), 0.4], [0.42, 0.56]);
            self.solid_at([x, 0.06], [along - 0.1, 0.03]);
            self.legs([x, deep / 2.0], [along - 0.08, deep - 0.1], LEG);
        }
        if dice.falls(88) {
            self.swivel([x + dice.within(-0.25, 0.25), dice.within(0.95, 1.12)], dice);
        }
    }

    /// An office chair: a column on five castors.
    fn swivel(&mut self, [x, y]: [f64; 2], dice: &mut Dice) {
        self.post([x, y], 0.03);
        let turn = dice.within(0.0, trig::TAU / 5.0);
        for castor in 0..5 {
            let (sin, cos) = trig::sin_cos(turn + trig::TAU / 5.0 * f64::from(castor));
            self.post([x + 0.27 * cos, y + 0.27 * sin], LEG);
        }
    }

    /// A chair of four legs that stands roughly straight.
    fn chair(&mut self, center: [f64; 2], dice: &mut Dice) {
        let (sin, cos) = trig::sin_cos(dice.within(-0.25, 0.25));
        for (x, y) in [(-0.19, -0.19), (0.19, -0.19), (0.19, 0.19), (-0.19, 0.19)] {
            self.post([center[0] + cos * x - sin * y, center[1] + sin * x + cos * y], THIN);
        }
    }

    /// A row of cabinets.
    pub(super) fn cabinets(count: i32, dice: &mut Dice) -> Self {
        let wide = dice.pick(&[0.8, 0.9, 1.0, 1.2]).unwrap_or(0.8);
        Self::solid(wide * f64::from(count), dice.pick(&[0.4, 0.42, 0.45]).unwrap_or(0.42))
    }

    /// A table for so many people on either side, with its chairs.
    pub(super) fn conference(seats: i32, dice: &mut Dice) -> Self {
        let (along, deep) = (0.75 * f64::from(seats) + 0.3, dice.within(0.95, 1.2));
        let mut piece = Self::taking(along, deep + 1.3);
        let middle = piece.size.y / 2.0;
        piece.legs([0.0, middle], [along - 0.2, deep - 0.2], 0.03);
        if along > 2.6 {
            piece.solid_at([0.0, middle], [0.5, 0.35]);
        }
        for seat in 0..seats {
            let x = 0.75 * (f64::from(seat) + 0.5 - f64::from(seats) / 2.0);
            for side in [-1.0, 1.0] {
                let away = deep / 2.0 + dice.within(0.15, 0.35);
                if dice.falls(92) {
                    piece.chair([x + dice.within(-0.06, 0.06), middle + side * away], dice);
                }
            }
        }
        piece
    }

    /// A round table on a column, with chairs around.
    pub(super) fn round_table(dice: &mut Dice) -> Self {
        let mut piece = Self::taking(2.0, 2.0);
        piece.post([0.0, 1.0], 0.06);
        let turn = dice.within(0.0, trig::FRAC_PI_2);
        for place in 0..4 {
            let (sin, cos) = trig::sin_cos(turn + trig::FRAC_PI_2 * f64::from(place));
            piece.post([0.33 * cos, 1.0 + 0.33 * sin], LEG);
            if dice.falls(80) {
                piece.chair([0.72 * cos, 1.0 + 0.72 * sin], dice);
            }
        }
        piece
    }

    /// A worktop, and a refrigerator beside it.
    pub(super) fn kitchenette(dice: &mut Dice) -> Self {
        let worktop = dice.within(1.6, 2.6);
        let mut piece = Self::taking(worktop + 0.7, 0.66);
        piece.solid_at([-0.35, 0.31], [worktop, 0.62]);
        piece.solid_at([worktop / 2.0, 0.33], [0.66, 0.66]);
        piece
    }

    /// A sofa with a low table before it.
    pub(super) fn sofa(dice: &mut Dice) -> Self {
        let along = dice.within(1.5, 2.2);
        let mut piece = Self::solid(along, 0.85);
        piece.size.y = 1.75;
        piece.legs([0.0, 1.45], [0.9, 0.45], LEG);
        piece
    }

    /// Cartons that somebody put down, none quite straight.
    pub(super) fn cartons(count: i32, dice: &mut Dice) -> Self {
        let mut piece = Self::taking(0.6 * f64::from(count), 0.62);
        for k in 0..count {
            let center = [0.6 * (f64::from(k) + 0.5 - f64::from(count) / 2.0), 0.31];
            let size = [dice.within(0.3, 0.44), dice.within(0.26, 0.36)];
            piece.boxes.push(BoxObstacle { center, size, heading_deg: dice.within(-25.0, 25.0) });
        }
        piece
    }

    /// A flower pot, a bin, a column: something round.
    pub(super) fn round(radius: f64) -> Self {
        let mut piece = Self::taking(2.0 * radius + 0.08, 2.0 * radius + 0.08);
        piece.post([0.0, radius + 0.04], radius);
        piece
    }

    /// A flip chart on three feet.
    pub(super) fn flip_chart() -> Self {
        let mut piece = Self::taking(0.7, 0.7);
        for [x, y] in [[-0.3, 0.15], [0.3, 0.15], [0.0, 0.6]] {
            piece.post([x, y], LEG);
        }
        piece
    }

    /// A chair for visitors.
    pub(super) fn visitor(dice: &mut Dice) -> Self {
        let mut piece = Self::taking(0.55, 0.6);
        piece.chair([0.0, 0.3], dice);
        piece
    }
}
