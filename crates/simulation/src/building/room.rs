use cogmap_geometry::{DVec2, Segment, trig};

use super::{
    piece::Piece,
    rect::{Rect, metres},
};
use crate::{BoxObstacle, Post, dice::Dice};

/// Edge of the fields in which a room is looked at, metres.
const FIELD: f64 = 0.1;
/// The share of a room's floor that furniture leaves open at least.
const OPEN: f64 = 0.42;

/// A room that is being furnished, so that one can still get from each door to each other.
pub(super) struct Room {
    low: DVec2,
    high: DVec2,
    /// How much room whoever walks here needs around the middle, metres.
    disc: f64,
    columns: usize,
    /// Where the middle of a walker cannot be.
    blocked: Vec<bool>,
    /// Spots that must be reached from each other, one before each door.
    doors: Vec<DVec2>,
    /// What is taken: footprints and the floor before doors.
    taken: Vec<[DVec2; 2]>,
    /// How many fields one could walk in when it was empty.
    walkable: usize,
    pub(super) boxes: Vec<BoxObstacle>,
    pub(super) posts: Vec<Post>,
}

impl Room {
    pub(super) fn new(rect: &Rect, disc: f64) -> Self {
        let (low, high) = (DVec2::from(metres(rect.low)), DVec2::from(metres(rect.high)));
        let [columns, rows] = ((high - low) / FIELD).to_array().map(|fields| fields.ceil() as usize);
        let (blocked, none) = (vec![false; columns * rows], Vec::new);
        let (doors, taken, boxes, posts) = (none(), Vec::new(), Vec::new(), Vec::new());
        let mut room = Self { low, high, disc, columns, blocked, doors, taken, walkable: 0, boxes, posts };
        room.block([low, high], |point| (point - low).min(high - point).min_element() < disc);
        room.walkable = room.blocked.iter().filter(|blocked| !**blocked).count();
        room
    }

    /// A door: the floor before it stays clear, and its leaf is in the way.
    pub(super) fn add_door(&mut self, spot: DVec2, clear: &Rect, leaf: Option<Segment>) {
        self.doors.push(spot);
        self.taken.push([metres(clear.low).into(), metres(clear.high).into()]);
        if let Some(leaf) = leaf {
            let disc = self.disc;
            self.block([leaf.a.min(leaf.b), leaf.a.max(leaf.b)], |point| leaf.distance_to(point) < disc);
        }
    }

    pub(super) fn size(&self) -> DVec2 {
        self.high - self.low
    }

    pub(super) fn middle(&self) -> DVec2 {
        self.low.midpoint(self.high)
    }

    /// Tries some places along the walls, corners first.
    pub(super) fn against_wall(&mut self, piece: &Piece, gap: f64, dice: &mut Dice) -> bool {
        (0..14).any(|_| {
            let quarter = dice.between(0, 3);
            let [along, _] = directions(quarter);
            let length = self.size().dot(along.abs());
            let slack = length - piece.size.x;
            if slack < 0.0 {
                return false;
            }
            let aside = match dice.between(0, 3) {
                0 => dice.within(0.0, 0.06).min(slack),
                1 => slack - dice.within(0.0, 0.06).min(slack),
                _ => dice.within(0.0, slack),
            };
            let corner = [
                self.low,
                DVec2::new(self.high.x, self.low.y),
                self.high,
                DVec2::new(self.low.x, self.high.y),
            ];
            let origin = corner[quarter as usize] + along * (aside + piece.size.x / 2.0);
            self.place(piece, origin, quarter, gap)
        })
    }

    /// Puts a piece around a spot, its wall turned by so many right angles.
    pub(super) fn around(&mut self, piece: &Piece, spot: DVec2, quarter: i32, gap: f64) -> bool {
        let [_, inward] = directions(quarter);
        self.place(piece, spot - inward * (piece.size.y / 2.0), quarter, gap)
    }

    /// Puts a piece down, its back at a point, unless it is in the way there.
    fn place(&mut self, piece: &Piece, origin: DVec2, quarter: i32, gap: f64) -> bool {
        let [along, inward] = directions(quarter);
        let at = |point: DVec2| origin + along * point.x + inward * point.y;
        let ends =
            [at(DVec2::new(-piece.size.x / 2.0, 0.0)), at(DVec2::new(piece.size.x / 2.0, piece.size.y))];
        let foot = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let inside = foot[0].cmpge(self.low - 1e-6).all() && foot[1].cmple(self.high + 1e-6).all();
        let overlaps =
            |[low, high]: &[DVec2; 2]| foot[0].cmplt(*high + gap).all() && foot[1].cmpgt(*low - gap).all();
        if !inside || self.taken.iter().any(overlaps) {
            return false;
        }
        let rounded = |point: [f64; 2]| at(point.into()).to_array().map(|c| (c * 1000.0).round() / 1000.0);
        let heading = f64::from(quarter) * 90.0;
        let boxes = piece.boxes.iter().map(|b| BoxObstacle {
            center: rounded(b.center),
            size: b.size.map(|c| (c * 100.0).round() / 100.0),
            heading_deg: (b.heading_deg + heading).round(),
        });
        let posts = piece.posts.iter().map(|p| Post { center: rounded(p.center), ..*p });
        self.stand(boxes.collect(), posts.collect(), foot)
    }

    fn stand(&mut self, boxes: Vec<BoxObstacle>, posts: Vec<Post>, foot: [DVec2; 2]) -> bool {
        let (before, disc) = (self.blocked.clone(), self.disc);
        for furniture in &boxes {
            let (sin, cos) = trig::sin_cos(furniture.heading_deg.to_radians());
            let half = DVec2::from(furniture.size) / 2.0;
            let center = DVec2::from(furniture.center);
            self.block([center - half.max_element(), center + half.max_element()], |point| {
                let away = point - center;
                let local = DVec2::new(away.dot(DVec2::new(cos, sin)), away.dot(DVec2::new(-sin, cos)));
                (local.abs() - half).max(DVec2::ZERO).length() < disc
            });
        }
        for post in &posts {
            let center = DVec2::from(post.center);
            let reach = disc + post.radius;
            self.block([center - post.radius, center + post.radius], |point| point.distance(center) < reach);
        }
        if !self.is_passable() {
            self.blocked = before;
            return false;
        }
        self.boxes.extend(boxes);
        self.posts.extend(posts);
        self.taken.push(foot);
        true
    }

    /// Blocks the fields around a box of floor whose middles something is true of.
    fn block(&mut self, [low, high]: [DVec2; 2], is_near: impl Fn(DVec2) -> bool) {
        let reach = self.disc + FIELD;
        let rows = self.blocked.len() / self.columns.max(1);
        let first = ((low - reach - self.low) / FIELD).max(DVec2::ZERO);
        let last = ((high + reach - self.low) / FIELD).max(DVec2::ZERO);
        for row in first.y as usize..(last.y as usize + 1).min(rows) {
            for column in first.x as usize..(last.x as usize + 1).min(self.columns) {
                let middle = self.low + (DVec2::new(column as f64, row as f64) + 0.5) * FIELD;
                if is_near(middle) {
                    self.blocked[row * self.columns + column] = true;
                }
            }
        }
    }

    /// Whether one gets from each door to each other, and most of what was open still is.
    fn is_passable(&self) -> bool {
        let spots: Option<Vec<usize>> = self.doors.iter().map(|&door| self.field_near(door)).collect();
        let Some(spots) = spots else { return false };
        let Some(&first) = spots.first() else { return true };
        let mut reached = vec![false; self.blocked.len()];
        let (mut open, mut count) = (vec![first], 0);
        reached[first] = true;
        while let Some(field) = open.pop() {
            count += 1;
            for next in self.beside(field) {
                if !self.blocked[next] && !std::mem::replace(&mut reached[next], true) {
                    open.push(next);
                }
            }
        }
        spots.iter().all(|&spot| reached[spot]) && count as f64 >= OPEN * self.walkable as f64
    }

    /// The open field around a point, or next to it.
    fn field_near(&self, point: DVec2) -> Option<usize> {
        let [column, row] = ((point - self.low) / FIELD).to_array().map(|field| field.max(0.0) as usize);
        let field = row * self.columns + column.min(self.columns - 1);
        let mut near = std::iter::once(field).chain(self.beside(field));
        near.find(|&field| self.blocked.get(field) == Some(&false))
    }

    fn beside(&self, field: usize) -> impl Iterator<Item = usize> + use<> {
        let (columns, count) = (self.columns, self.blocked.len());
        let column = field % columns;
        let left = (column > 0).then(|| field - 1);
        let right = (column + 1 < columns).then_some(field + 1);
        let others = [left, right, field.checked_sub(columns), Some(field + columns)];
        others.into_iter().flatten().filter(move |next| *next < count)
    }
}

/// Along a wall and away from it, for the walls in counter-clockwise order from the lowest.
fn directions(quarter: i32) -> [DVec2; 2] {
    let along = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y][quarter as usize % 4];
    [along, along.perp()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_put_where_it_would_shut_a_door_off() {
        let mut room = Room::new(&Rect::new([0, 400], [0, 200]), 0.35);
        for x in [0.45, 3.55] {
            room.add_door(DVec2::new(x, 1.0), &Rect::new([0, 1], [0, 1]), None);
        }
        assert!(!room.around(&Piece::solid(1.0, 0.8), DVec2::new(2.0, 1.0), 0, 0.0), "0.6 m on both sides");
        assert!(room.around(&Piece::solid(1.0, 0.4), DVec2::new(2.0, 0.2), 0, 0.0));
        assert!(!room.around(&Piece::solid(0.5, 0.3), DVec2::new(2.3, 0.3), 0, 0.0), "taken");
        assert_eq!(room.boxes.len(), 1);
    }

    #[test]
    fn furniture_turns_its_back_to_its_wall() {
        let mut dice = Dice::new(5);
        let mut room = Room::new(&Rect::new([0, 900], [0, 800]), 0.35);
        for _ in 0..12 {
            room.against_wall(&Piece::solid(1.2, 0.4), 0.1, &mut dice);
        }
        assert!(room.boxes.len() > 6);
        for furniture in &room.boxes {
            let [x, y] = furniture.center;
            let off = [x, 9.0 - x, y, 8.0 - y].into_iter().fold(9.0, f64::min);
            assert!((off - 0.2).abs() < 1e-9, "{furniture:?}");
        }
    }
}
