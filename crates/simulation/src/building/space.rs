use super::{
    layout::{Layout, Strip},
    rect::Rect,
};
use crate::dice::Dice;

/// A room or a corridor.
#[derive(Clone, Debug)]
pub(super) struct Space {
    pub(super) rect: Rect,
    pub(super) kind: Kind,
    /// Shown to people.
    pub(super) name: String,
}

/// What a space is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Corridor,
    Office,
    OpenOffice,
    Meeting,
    Kitchen,
    Lounge,
    Copier,
    Store,
    Washroom,
}

/// No room is narrower, centimetres.
const NARROWEST: i32 = 180;
/// A room this deep may be divided into a front and a back room, centimetres.
const DIVISIBLE: i32 = 560;

/// Corridors and rooms of a layout, unnamed.
pub(super) fn spaces(layout: &Layout, dice: &mut Dice) -> Vec<Space> {
    let corridors = layout.corridors.iter();
    let mut spaces: Vec<Space> = corridors.map(|&rect| space(rect, Kind::Corridor)).collect();
    for strip in &layout.strips {
        for bay in bays(strip, layout.wall, dice) {
            // A shaft: solid from floor to ceiling.
            if bay.area() < 11.0 && dice.falls(20) {
                continue;
            }
            spaces.extend(divided(bay, layout.wall, dice).into_iter().map(|rect| {
                let kind = kind_of(&rect, dice);
                space(rect, kind)
            }));
        }
    }
    spaces
}

fn space(rect: Rect, kind: Kind) -> Space {
    Space { rect, kind, name: String::new() }
}

/// The rooms of a strip, one after the other.
fn bays(strip: &Strip, wall: i32, dice: &mut Dice) -> Vec<Rect> {
    let [mut at, end] = strip.rect.span(strip.along);
    let across = strip.rect.span(1 - strip.along);
    let usual = if dice.falls(50) { dice.between(270, 420) } else { 0 };
    let mut bays = Vec::new();
    while at < end {
        let mut width = width(usual, dice);
        if end - at - width - wall < NARROWEST.max(240) {
            width = end - at;
        }
        bays.push(Rect::on(strip.along, [at, at + width], across));
        at += width + wall;
    }
    bays
}

/// How wide a room is, centimetres; rows of like rooms are usual in offices.
fn width(usual: i32, dice: &mut Dice) -> i32 {
    match dice.between(1, 100) {
        ..=45 if usual > 0 => usual,
        ..=55 => dice.between(260, 420),
        56..=78 => dice.between(420, 620),
        79..=90 => dice.between(620, 960),
        _ => dice.between(NARROWEST, 260),
    }
}

/// One room, or a front and a back room.
fn divided(bay: Rect, wall: i32, dice: &mut Dice) -> Vec<Rect> {
    let axis = usize::from(bay.size(1) > bay.size(0));
    let [low, high] = bay.span(axis);
    if high - low < DIVISIBLE || bay.sides()[0] > 460 || !dice.falls(22) {
        return vec![bay];
    }
    let at = dice.between(low + 230, high - wall - 230);
    let across = bay.span(1 - axis);
    [[low, at], [at + wall, high]].map(|along| Rect::on(axis, along, across)).to_vec()
}

fn kind_of(rect: &Rect, dice: &mut Dice) -> Kind {
    use Kind::{Copier, Kitchen, Lounge, Meeting, Office, OpenOffice, Store, Washroom};
    let few = [Store, Store, Copier, Washroom, Office];
    let small = [Office, Office, Office, Office, Office, Kitchen, Copier, Store, Meeting, Washroom];
    let middling = [Office, Office, Office, Office, Meeting, Meeting, Kitchen, Lounge];
    let large = [OpenOffice, OpenOffice, OpenOffice, Meeting, Lounge];
    let choice = match rect.area() {
        _ if rect.sides()[0] < 230 => &few[..],
        ..9.0 => &few[..],
        ..20.0 => &small[..],
        ..34.0 => &middling[..],
        _ => &large[..],
    };
    dice.pick(choice).unwrap_or(Office)
}

/// Numbers the rooms of each kind.
pub(super) fn name_all(spaces: &mut [Space]) {
    let kinds: Vec<Kind> = spaces.iter().map(|space| space.kind).collect();
    for (index, space) in spaces.iter_mut().enumerate() {
        let number = kinds[..=index].iter().filter(|kind| **kind == space.kind).count();
        let only = kinds.iter().filter(|kind| **kind == space.kind).count() == 1;
        let word = space.kind.word();
        space.name = if only { word.to_owned() } else { format!("{word} {number}") };
    }
}

impl Kind {
    fn word(self) -> &'static str {
        match self {
            Self::Corridor => "Corridor",
            Self::Office => "Office",
            Self::OpenOffice => "Open office",
            Self::Meeting => "Meeting room",
            Self::Kitchen => "Kitchen",
            Self::Lounge => "Lounge",
            Self::Copier => "Copy room",
            Self::Store => "Store",
            Self::Washroom => "Washroom",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rooms_lie_apart_by_a_wall_and_fill_the_floor() {
        for seed in 0..200 {
            let mut dice = Dice::new(seed);
            let layout = Layout::drawn(&mut dice);
            let spaces = spaces(&layout, &mut dice);
            let rooms: Vec<&Space> = spaces.iter().filter(|s| s.kind != Kind::Corridor).collect();
            for (i, room) in rooms.iter().enumerate() {
                // The room at the end of a corridor is as narrow as that.
                assert!(room.rect.sides()[0] >= NARROWEST.min(160), "seed {seed}: {room:?}");
                let near = room.rect.grown(layout.wall - 1);
                assert!(rooms[..i].iter().all(|other| !near.overlaps(&other.rect)), "seed {seed}");
            }
            let filled: f64 = rooms.iter().map(|room| room.rect.area()).sum();
            let floor: f64 = layout.strips.iter().map(|strip| strip.rect.area()).sum();
            assert!(filled > 0.8 * floor, "seed {seed}: {filled} of {floor}");
        }
    }
}
