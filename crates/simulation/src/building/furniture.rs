use cogmap_geometry::{DVec2, Segment};

use super::{Building, doorway::Doorway, piece::Piece, rect::metres, room::Room, space::Kind};
use crate::{BoxObstacle, Door, Post, dice::Dice};

/// How much room a walker needs around the middle: in rooms what the robot needs and 10 cm, in
/// corridors more, metres.
const DISCS: [f64; 2] = [0.36, 0.52];
/// How far into a space the spot before a door lies, centimetres.
const STEP_IN: i32 = 45;
/// How far before a door nothing stands, centimetres.
const CLEAR: i32 = 95;

/// Furnishes every space.
pub(super) fn furnish(building: &Building, dice: &mut Dice) -> (Vec<BoxObstacle>, Vec<Post>) {
    let (mut boxes, mut posts) = (Vec::new(), Vec::new());
    for (index, space) in building.spaces.iter().enumerate() {
        let mut room = Room::new(&space.rect, DISCS[usize::from(space.kind == Kind::Corridor)]);
        for doorway in &building.doorways {
            add_door(&mut room, doorway, index);
        }
        fill(&mut room, space.kind, dice);
        boxes.append(&mut room.boxes);
        posts.append(&mut room.posts);
    }
    (boxes, posts)
}

fn add_door(room: &mut Room, doorway: &Doorway, space: usize) {
    let Some(side) = doorway.between.iter().position(|&joined| joined == space) else { return };
    let clear = doorway.approach(side, CLEAR);
    let mut spot = [0, 1].map(|axis| (clear.low[axis] + clear.high[axis]) / 2);
    let [low, high] = doorway.opening.span(doorway.through);
    spot[doorway.through] = if side == 0 { low - STEP_IN } else { high + STEP_IN };
    let leaf = doorway.leaf.as_ref().filter(|leaf| leaf.open).map(Door::leaf);
    let inside = |leaf: &Segment| room.middle().distance(leaf.midpoint()) < room.size().length();
    room.add_door(metres(spot).into(), &clear, leaf.filter(inside));
}

fn fill(room: &mut Room, kind: Kind, dice: &mut Dice) {
    match kind {
        Kind::Corridor => corridor(room, dice),
        Kind::Office => office(room, dice),
        Kind::OpenOffice => open_office(room, dice),
        Kind::Meeting => meeting(room, dice),
        Kind::Kitchen => kitchen(room, dice),
        Kind::Lounge => lounge(room, dice),
        Kind::Copier => copier(room, dice),
        Kind::Store => store(room, dice),
        Kind::Washroom => washroom(room, dice),
    }
}

/// Here and there a cabinet, a plant, something to be fetched.
fn corridor(room: &mut Room, dice: &mut Dice) {
    let chances = (room.size().max_element() / 6.0) as i32;
    for _ in 0..chances {
        let piece = match dice.between(1, 100) {
            ..=30 => Piece::cabinets(dice.between(1, 3), dice),
            31..=50 => Piece::round(dice.within(0.13, 0.19)),
            51..=62 => Piece::solid(0.36, 0.36),
            63..=72 => Piece::visitor(dice),
            73..=80 => Piece::cartons(1, dice),
            _ => continue,
        };
        room.against_wall(&piece, 0.0, dice);
    }
}

fn office(room: &mut Room, dice: &mut Dice) {
    let area = room.size().element_product();
    if area > 17.0 && dice.falls(45) {
        let turned = i32::from(room.size().y > room.size().x);
        let spot = room.middle() + DVec2::new(dice.within(-0.5, 0.5), dice.within(-0.5, 0.5));
        room.around(&Piece::island(1, dice), spot, turned, 0.1);
    }
    for _ in 0..((area / 9.0).round() as i32).clamp(1, 4) {
        room.against_wall(&Piece::desk(dice), 0.12, dice);
    }
    for _ in 0..dice.between(1, 2) {
        room.against_wall(&Piece::cabinets(dice.between(1, 3), dice), 0.02, dice);
    }
    odds(room, dice);
}

/// Rows of desks with aisles between, cabinets along the walls.
fn open_office(room: &mut Room, dice: &mut Dice) {
    let turned = i32::from(dice.falls(50) == (room.size().x > 9.0));
    let pairs = dice.between(1, 3);
    let foot = Piece::island(pairs, dice).size;
    let foot = if turned == 1 { DVec2::new(foot.y, foot.x) } else { foot };
    let pitch = foot + dice.within(0.9, 1.3);
    let counts = ((room.size() - 1.2 + 0.9) / pitch).floor().max(DVec2::ONE);
    let first = room.middle() - pitch * (counts - 1.0) / 2.0;
    for row in 0..counts.y as i32 {
        for column in 0..counts.x as i32 {
            let spot = first + pitch * DVec2::new(f64::from(column), f64::from(row));
            if dice.falls(92) && !room.around(&Piece::island(pairs, dice), spot, turned, 0.2) {
                room.around(&Piece::island(1, dice), spot, turned, 0.2);
            }
        }
    }
    for _ in 0..3 {
        room.against_wall(&Piece::cabinets(dice.between(2, 5), dice), 0.1, dice);
    }
    odds(room, dice);
    odds(room, dice);
}

fn meeting(room: &mut Room, dice: &mut Dice) {
    let turned = i32::from(room.size().y > room.size().x);
    let seats = ((room.size().max_element() - 2.2) / 0.75) as i32;
    let spot = room.middle();
    for seats in (2..=seats.clamp(2, 8)).rev() {
        if room.around(&Piece::conference(seats, dice), spot, turned, 0.0) {
            break;
        }
    }
    if dice.falls(60) {
        room.against_wall(&Piece::cabinets(dice.between(1, 2), dice), 0.1, dice);
    }
    if dice.falls(60) {
        room.against_wall(&Piece::flip_chart(), 0.1, dice);
    }
    odds(room, dice);
}

fn kitchen(room: &mut Room, dice: &mut Dice) {
    room.against_wall(&Piece::kitchenette(dice), 0.1, dice);
    let tables = (room.size().element_product() / 9.0) as i32;
    for _ in 0..tables.clamp(1, 4) {
        let spread = (room.size() / 2.0 - 1.0).max(DVec2::ZERO);
        let aside = DVec2::new(dice.within(-1.0, 1.0), dice.within(-1.0, 1.0)) * spread;
        room.around(&Piece::round_table(dice), room.middle() + aside, 0, 0.1);
    }
    odds(room, dice);
}

fn lounge(room: &mut Room, dice: &mut Dice) {
    for _ in 0..dice.between(2, 4) {
        room.against_wall(&Piece::sofa(dice), 0.2, dice);
    }
    let spot = room.middle() + DVec2::new(dice.within(-1.0, 1.0), dice.within(-1.0, 1.0));
    room.around(&Piece::round_table(dice), spot, 0, 0.2);
    odds(room, dice);
    odds(room, dice);
}

fn copier(room: &mut Room, dice: &mut Dice) {
    room.against_wall(&Piece::solid(1.15, 0.7), 0.1, dice);
    room.against_wall(&Piece::cabinets(dice.between(1, 3), dice), 0.02, dice);
    room.against_wall(&Piece::cartons(dice.between(1, 2), dice), 0.05, dice);
    odds(room, dice);
}

fn store(room: &mut Room, dice: &mut Dice) {
    for _ in 0..4 {
        room.against_wall(&Piece::cabinets(dice.between(1, 4), dice), 0.02, dice);
    }
    for _ in 0..dice.between(1, 3) {
        room.against_wall(&Piece::cartons(dice.between(1, 3), dice), 0.05, dice);
    }
}

fn washroom(room: &mut Room, dice: &mut Dice) {
    room.against_wall(&Piece::solid(0.95 * f64::from(dice.between(1, 3)), 1.3), 0.1, dice);
    room.against_wall(&Piece::solid(dice.within(0.6, 1.6), 0.5), 0.1, dice);
    room.against_wall(&Piece::round(0.14), 0.05, dice);
}

/// What stands about in any room.
fn odds(room: &mut Room, dice: &mut Dice) {
    if dice.falls(55) {
        room.against_wall(&Piece::round(dice.within(0.12, 0.2)), 0.05, dice);
    }
    if dice.falls(45) {
        room.against_wall(&Piece::round(0.13), 0.05, dice);
    }
    if dice.falls(30) {
        room.against_wall(&Piece::visitor(dice), 0.1, dice);
    }
    if dice.falls(18) {
        room.against_wall(&Piece::cartons(dice.between(1, 2), dice), 0.05, dice);
    }
}
