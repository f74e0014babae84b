use super::{
    rect::{Rect, metres},
    space::{Kind, Space},
};
use crate::{Door, dice::Dice};

/// How wide a door is, centimetres.
const DOOR: [i32; 2] = [85, 100];
/// How wide an opening without a door is that a lounge or a kitchen has to its corridor, centimetres.
const OPENING: [i32; 2] = [150, 320];
/// What the wall goes on beside a door at least, centimetres.
const JAMB: i32 = 14;
/// How far before a door nothing stands: in a room, and in a corridor, centimetres.
const BEFORE: [i32; 2] = [105, 45];

/// A passage through the wall between two spaces, or the edge along which two corridors meet.
#[derive(Clone, Debug)]
pub(super) struct Doorway {
    /// The floor between the jambs, as deep as the wall.
    pub(super) opening: Rect,
    /// The axis on which one walks through.
    pub(super) through: usize,
    /// What it joins, the space at the lower coordinates first.
    pub(super) between: [usize; 2],
    /// The leaf; some doorways have none.
    pub(super) leaf: Option<Door>,
}

/// Two spaces that one wall parts.
#[derive(Clone, Copy)]
struct Neighbours {
    between: [usize; 2],
    through: usize,
    wall: Rect,
}

impl Doorway {
    /// Where nothing may stand, on the side of the first or the second space.
    pub(super) fn approach(&self, side: usize, before: i32) -> Rect {
        let mut zone = self.opening;
        if side == 0 {
            zone.low[self.through] -= before;
        } else {
            zone.high[self.through] += before;
        }
        zone.low[1 - self.through] -= 6;
        zone.high[1 - self.through] += 6;
        zone
    }

    fn approaches(&self, spaces: &[Space]) -> [Rect; 2] {
        let [first, second] = self.between.map(|space| spaces[space].kind == Kind::Corridor);
        // Along a corridor with a door in it no other door opens near that door.
        let before = |here: bool, there: bool| match (here, there) {
            (true, true) => 120,
            (true, false) => BEFORE[1],
            _ => BEFORE[0],
        };
        let mut zones = [self.approach(0, before(first, second)), self.approach(1, before(second, first))];
        if first && second {
            zones.iter_mut().for_each(|zone| *zone = zone.grown(60));
        }
        zones
    }
}

/// Doors so that every room can be reached, and some more for ways around. Rooms that no door can be
/// given to are left out.
pub(super) fn connect(spaces: &mut Vec<Space>, wall: i32, dice: &mut Dice) -> Vec<Doorway> {
    let mut doorways = meetings(spaces);
    let neighbours = dice.shuffled(neighbours(spaces, wall));
    let is_corridor: Vec<bool> = spaces.iter().map(|space| space.kind == Kind::Corridor).collect();
    let corridors = |pair: &Neighbours| pair.between.iter().filter(|&&space| is_corridor[space]).count();
    let mut plan = Plan { spaces, doorways: &mut doorways, dice };
    for pair in neighbours.iter().filter(|pair| corridors(pair) == 2) {
        plan.open(*pair, false);
    }
    for pair in neighbours.iter().filter(|pair| corridors(pair) == 1) {
        plan.open_to_corridor(*pair);
    }
    while neighbours.iter().any(|pair| plan.joins_something_new(pair) && plan.open(*pair, false)) {}
    for pair in neighbours.iter().filter(|pair| corridors(pair) == 0) {
        if plan.dice.falls(16) && !plan.are_joined(pair) {
            plan.open(*pair, true);
        }
    }
    let reached = reached(spaces.len(), &doorways);
    leave_out(spaces, &mut doorways, &reached);
    doorways
}

struct Plan<'a> {
    spaces: &'a [Space],
    doorways: &'a mut Vec<Doorway>,
    dice: &'a mut Dice,
}

impl Plan<'_> {
    /// A room's first door to a corridor, or perhaps a second one.
    fn open_to_corridor(&mut self, pair: Neighbours) {
        let [first, second] = pair.between;
        let room = if self.spaces[first].kind == Kind::Corridor { second } else { first };
        let doors = self.doorways.iter().filter(|door| door.between.contains(&room)).count();
        let long = pair.wall.size(1 - pair.through) > 600;
        if doors == 0 {
            self.open(pair, false);
            if long && self.dice.falls(55) {
                self.open(pair, true);
            }
        } else if doors == 1 && self.dice.falls(30) {
            self.open(pair, true);
        }
    }

    /// Whether a door here would lead from where one can get to where one cannot yet.
    fn joins_something_new(&self, pair: &Neighbours) -> bool {
        let reached = reached(self.spaces.len(), self.doorways);
        let [first, second] = pair.between;
        reached[first] != reached[second]
    }

    fn are_joined(&self, pair: &Neighbours) -> bool {
        self.doorways.iter().any(|door| door.between == pair.between)
    }

    /// Makes a doorway where the wall has room for one; `spare` ones may have a closed door.
    fn open(&mut self, pair: Neighbours, spare: bool) -> bool {
        let kinds = pair.between.map(|space| self.spaces[space].kind);
        let corridors = kinds.iter().filter(|kind| **kind == Kind::Corridor).count();
        let airy = kinds.iter().any(|kind| matches!(kind, Kind::Lounge | Kind::Kitchen));
        let wide = corridors == 1 && airy && !spare && self.dice.falls(50);
        let [low, high] = if wide { OPENING } else { DOOR };
        for _ in 0..8 {
            let width = self.dice.between(low, high);
            let Some(opening) = self.place(&pair, width, corridors == 2) else { continue };
            let Neighbours { between, through, .. } = pair;
            let mut doorway = Doorway { opening, through, between, leaf: None };
            if self.is_clear(&doorway) {
                doorway.leaf = (!wide && self.dice.falls(88)).then(|| self.leaf(&doorway, spare));
                self.doorways.push(doorway);
                return true;
            }
        }
        false
    }

    /// An opening of some width in a wall: near one of its ends, anywhere, or in the middle.
    fn place(&mut self, pair: &Neighbours, width: i32, middle: bool) -> Option<Rect> {
        let axis = 1 - pair.through;
        let [low, high] = pair.wall.span(axis);
        let room = high - low - width - 2 * JAMB;
        if room < 0 {
            return None;
        }
        let aside = match self.dice.between(1, 100) {
            _ if middle => room / 2,
            ..=35 => self.dice.between(0, room.min(25)),
            36..=70 => room - self.dice.between(0, room.min(25)),
            _ => self.dice.between(0, room),
        };
        let from = low + JAMB + aside;
        Some(Rect::on(axis, [from, from + width], pair.wall.span(pair.through)))
    }

    /// Whether no other door's leaf or doorway is in the way.
    fn is_clear(&self, doorway: &Doorway) -> bool {
        let zones = doorway.approaches(self.spaces);
        let others = self.doorways.iter().filter(|other| other.opening.area() > 0.0);
        let mut taken = others.flat_map(|other| other.approaches(self.spaces));
        taken.all(|other| zones.iter().all(|zone| !zone.overlaps(&other)))
    }

    /// A leaf that opens away from the corridor.
    fn leaf(&mut self, doorway: &Doorway, spare: bool) -> Door {
        let kinds = doorway.between.map(|space| self.spaces[space].kind);
        let into = match kinds {
            [Kind::Corridor, Kind::Corridor] => usize::from(self.dice.falls(50)),
            [_, Kind::Corridor] => 0,
            [Kind::Corridor, _] => 1,
            _ => usize::from(self.dice.falls(50)),
        };
        let ([hinge, latch], open) = (leaf_ends(doorway, into), !(spare && self.dice.falls(25)));
        Door { name: String::new(), hinge: metres(hinge), latch: metres(latch), open }
    }
}

/// Hinge and latch of a leaf that opens counter-clockwise into a space.
fn leaf_ends(doorway: &Doorway, into: usize) -> [[i32; 2]; 2] {
    let (through, along) = (doorway.through, 1 - doorway.through);
    let face = doorway.opening.span(through)[into];
    let at = |end: usize| {
        let mut point = [face; 2];
        point[along] = doorway.opening.span(along)[end];
        point
    };
    let from_low = (into == 1) == (through == 1);
    if from_low { [at(0), at(1)] } else { [at(1), at(0)] }
}

fn meetings(spaces: &[Space]) -> Vec<Doorway> {
    let corridors = spaces.iter().filter(|space| space.kind == Kind::Corridor).count();
    let mut meetings = Vec::new();
    for first in 0..corridors {
        for second in 0..corridors {
            let edge = shared_wall(&spaces[first].rect, &spaces[second].rect, 0);
            let meeting =
                |(through, opening)| Doorway { opening, through, between: [first, second], leaf: None };
            meetings.extend(edge.map(meeting));
        }
    }
    meetings
}

fn neighbours(spaces: &[Space], wall: i32) -> Vec<Neighbours> {
    let mut pairs = Vec::new();
    for (first, a) in spaces.iter().enumerate() {
        for (second, b) in spaces.iter().enumerate() {
            let found = shared_wall(&a.rect, &b.rect, wall);
            pairs.extend(found.map(|(through, wall)| Neighbours { between: [first, second], through, wall }));
        }
    }
    pairs
}

/// The wall of some thickness that lies between a space and the next at higher coordinates.
fn shared_wall(a: &Rect, b: &Rect, wall: i32) -> Option<(usize, Rect)> {
    [0, 1].into_iter().find_map(|through| {
        let apart = b.low[through] - a.high[through];
        let along = a.shared(b, 1 - through)?;
        let between = Rect::on(through, [a.high[through], b.low[through]], along);
        (apart == wall).then_some((through, between))
    })
}

/// Which spaces can be reached from the first one through open doorways.
fn reached(count: usize, doorways: &[Doorway]) -> Vec<bool> {
    let mut reached = vec![false; count];
    reached[0] = true;
    let is_shut = |door: &Doorway| door.leaf.as_ref().is_some_and(|leaf| !leaf.open);
    loop {
        let passes = doorways.iter().filter(|door| !is_shut(door)).map(|door| door.between);
        let next = passes.filter(|&[a, b]| reached[a] != reached[b]).collect::<Vec<_>>();
        if next.is_empty() {
            return reached;
        }
        next.into_iter().flatten().for_each(|space| reached[space] = true);
    }
}

/// Forgets the spaces that nobody can get to.
fn leave_out(spaces: &mut Vec<Space>, doorways: &mut Vec<Doorway>, reached: &[bool]) {
    let number: Vec<usize> =
        (0..reached.len()).map(|k| reached[..k].iter().filter(|r| **r).count()).collect();
    doorways.retain(|door| door.between.iter().all(|&space| reached[space]));
    doorways.iter_mut().for_each(|door| door.between = door.between.map(|space| number[space]));
    let mut keep = reached.iter();
    spaces.retain(|_| keep.next().copied().unwrap_or(false));
}

/// Calls each door by the room that it leads to.
pub(super) fn name_all(doorways: &mut [Doorway], spaces: &[Space]) {
    let slug = |space: usize| spaces[space].name.to_lowercase().replace(' ', "-");
    let mut names: Vec<String> = Vec::new();
    for doorway in doorways {
        let Some(leaf) = &mut doorway.leaf else { continue };
        let [a, b] = doorway.between;
        let name = match [a, b].map(|space| spaces[space].kind == Kind::Corridor) {
            [true, true] => "corridor-door".to_owned(),
            [true, false] => slug(b),
            [false, true] => slug(a),
            [false, false] => format!("{}-{}", slug(a), slug(b)),
        };
        let before = names.iter().filter(|other| **other == name).count();
        leaf.name =
            if before == 0 { name.clone() } else { format!("{name}-{}", (b'a' + before as u8) as char) };
        names.push(name);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cogmap_geometry::DVec2;

    #[test]
    fn a_leaf_opens_into_the_space_that_it_is_to_open_into() {
        let opening = Rect::new([100, 190], [500, 512]);
        for (through, opening) in [(1, opening), (0, opening.mirrored(true, [false, false]))] {
            for into in 0..2 {
                let doorway = Doorway { opening, through, between: [0, 1], leaf: None };
                let [hinge, latch] = leaf_ends(&doorway, into).map(metres);
                let leaf = Door { name: String::new(), hinge, latch, open: true }.leaf();
                let inward = (leaf.b - leaf.a).to_array()[through];
                assert!((inward.abs() - 0.9).abs() < 1e-9 && (inward > 0.0) == (into == 1));
                assert!((DVec2::from(hinge).distance(latch.into()) - 0.9).abs() < 1e-9);
            }
        }
    }
}
