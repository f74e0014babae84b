use super::floor::Floor;

/// The corners of a closed line, the first again at its end: columns and rows of pixel corners.
pub(super) type Contour = Vec<[u32; 2]>;

/// The most corners that all outlines of a plan may have before they are drawn with fewer.
const CORNERS_MAX: usize = 4_000_000;
/// Along the upper side of a free pixel, then in turns to the right.
const STEPS: [[i64; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];

/// The outlines of the floor, along the edges of its pixels and with the floor on their right.
/// Pixels that touch at a corner only are not connected. `None` where there are too many corners.
pub(super) fn contours(floor: &Floor) -> Option<Vec<Contour>> {
    let mut walk = Walk { floor, seen: vec![false; floor.pixels()] };
    let mut contours = Vec::new();
    let mut corners = 0;
    for row in 0..floor.height {
        for column in 0..floor.width {
            if walk.is_upper_side(column, row) && !walk.seen[row * floor.width + column] {
                let contour = walk.around([column as i64, row as i64]);
                corners += contour.len();
                contours.push(contour);
                if corners > CORNERS_MAX {
                    return None;
                }
            }
        }
    }
    Some(contours)
}

/// A walk along edges that marks the upper sides which it has passed.
struct Walk<'a> {
    floor: &'a Floor,
    seen: Vec<bool>,
}

impl Walk<'_> {
    fn is_upper_side(&self, column: usize, row: usize) -> bool {
        let (column, row) = (column as i64, row as i64);
        self.floor.is_free(column, row) && !self.floor.is_free(column, row - 1)
    }

    /// The outline that begins with the upper side of a pixel.
    fn around(&mut self, first: [i64; 2]) -> Contour {
        let (mut at, mut direction) = (first, 0);
        let mut contour = Contour::new();
        loop {
            if direction == 0 {
                self.seen[at[1] as usize * self.floor.width + at[0] as usize] = true;
            }
            let [dx, dy] = STEPS[direction];
            at = [at[0] + dx, at[1] + dy];
            let turn = self.turn(at, direction);
            if turn != 0 {
                contour.push(at.map(|coordinate| coordinate as u32));
                direction = (direction + turn) % 4;
            }
            if at == first && direction == 0 {
                break;
            }
        }
        contour.extend(contour.first().copied());
        contour
    }

    /// How to go on at a corner: 0 straight, 1 to the right, 3 to the left.
    fn turn(&self, [x, y]: [i64; 2], direction: usize) -> usize {
        let [right, left] = match direction {
            0 => [[x, y], [x, y - 1]],
            1 => [[x - 1, y], [x, y]],
            2 => [[x - 1, y - 1], [x - 1, y]],
            _ => [[x, y - 1], [x - 1, y - 1]],
        };
        match [right, left].map(|[column, row]| self.floor.is_free(column, row)) {
            [false, _] => 1,
            [true, false] => 0,
            [true, true] => 3,
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::plan::{map_server::MapServer, picture::Picture};

    /// Twice the area that a line goes round, positive with the inside on its right.
    fn double_area(contour: &Contour) -> i64 {
        let corners = contour.iter().map(|corner| corner.map(i64::from)).collect::<Vec<_>>();
        corners.windows(2).map(|ends| ends[0][0] * ends[1][1] - ends[1][0] * ends[0][1]).sum()
    }

    proptest! {
        #[test]
        fn the_outlines_enclose_the_free_pixels_and_no_others(
            brightness in prop::collection::vec(prop_oneof![Just(0_u8), Just(255)], 99),
        ) {
            let free = brightness.iter().filter(|shade| **shade == 255).count();
            let picture = Picture { width: 11, height: 9, brightness };
            let floor = Floor::of(&picture, &MapServer::of_picture("plan.png", 0.05));
            let contours = contours(&floor).unwrap();
            prop_assert_eq!(contours.iter().map(double_area).sum::<i64>(), 2 * free as i64);
            for contour in &contours {
                prop_assert_eq!(contour.first(), contour.last());
                let straight = |ends: &[[u32; 2]]| (ends[0][0] == ends[1][0]) != (ends[0][1] == ends[1][1]);
                prop_assert!(contour.windows(2).all(straight), "{:?}", contour);
            }
        }
    }
}
