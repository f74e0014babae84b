use super::{map_server::MapServer, picture::Picture};

/// A step to the next pixel, in thirds of a pixel.
const STRAIGHT: u32 = 3;
/// A step to a diagonal neighbour: 1.33 pixels instead of 1.41.
const DIAGONAL: u32 = 4;

/// Which pixels of a plan are free.
pub(super) struct Floor {
    pub(super) width: usize,
    pub(super) height: usize,
    free: Vec<bool>,
}

impl Floor {
    pub(super) fn of(picture: &Picture, map: &MapServer) -> Self {
        let is_free = |&brightness: &u8| {
            let brightness = f64::from(brightness) / 255.0;
            let darkness = if map.negate { brightness } else { 1.0 - brightness };
            darkness < map.free_thresh
        };
        let free = picture.brightness.iter().map(is_free).collect();
        Self { width: picture.width, height: picture.height, free }
    }

    pub(super) fn pixels(&self) -> usize {
        self.free.len()
    }

    pub(super) fn free_pixels(&self) -> usize {
        self.free.iter().filter(|free| **free).count()
    }

    /// Whether the pixel in a column and a row is free; nothing outside the picture is.
    pub(super) fn is_free(&self, column: i64, row: i64) -> bool {
        let [Ok(column), Ok(row)] = [column, row].map(usize::try_from) else { return false };
        column < self.width && self.free.get(row * self.width + column).is_some_and(|free| *free)
    }

    /// The place with the most room, in columns and rows, of the largest connected part of the floor
    /// on which a disc of a radius, in pixels, can move; `None` where there is no room at all.
    pub(super) fn roomiest(&self, radius: f64) -> Option<[usize; 2]> {
        let room = self.room();
        // Walls are drawn within a pixel of where they are, and a pixel's middle is half one from its edge.
        let needed = ((radius + 1.5) * f64::from(STRAIGHT)).ceil() as u32;
        let mut new: Vec<bool> = room.iter().map(|room| *room >= needed).collect();
        let mut best: Option<(usize, usize)> = None;
        for first in 0..new.len() {
            let part = self.flood(first, &mut new);
            if part.len() > best.map_or(0, |(size, _)| size) {
                let roomiest = part.iter().copied().max_by_key(|&cell| (room[cell], std::cmp::Reverse(cell)));
                best = roomiest.map(|cell| (part.len(), cell));
            }
        }
        best.map(|(_, cell)| [cell % self.width, cell / self.width])
    }

    /// Makes everything solid that is not connected with a free pixel.
    pub(super) fn keep_around(&mut self, [column, row]: [usize; 2]) {
        let mut free = self.free.clone();
        let part = self.flood(row * self.width + column, &mut free);
        self.free.fill(false);
        for cell in part {
            self.free[cell] = true;
        }
    }

    /// The pixels that are connected with `first` side by side, taken out of those that are open.
    fn flood(&self, first: usize, open: &mut [bool]) -> Vec<usize> {
        let mut part = Vec::new();
        if !std::mem::replace(&mut open[first], false) {
            return part;
        }
        part.push(first);
        let mut next = 0;
        while let Some(&cell) = part.get(next) {
            next += 1;
            let column = cell % self.width;
            let sides = [
                (column > 0).then(|| cell - 1),
                (column + 1 < self.width).then_some(cell + 1),
                cell.checked_sub(self.width),
                Some(cell + self.width).filter(|&below| below < open.len()),
            ];
            for side in sides.into_iter().flatten() {
                if std::mem::replace(&mut open[side], false) {
                    part.push(side);
                }
            }
        }
        part
    }

    /// How far each pixel is from the nearest that is not free, in thirds of a pixel (a chamfer
    /// transform: once down, once up).
    fn room(&self) -> Vec<u32> {
        let (width, cells) = (self.width, self.free.len());
        let mut room: Vec<u32> = self.free.iter().map(|free| if *free { u32::MAX } else { 0 }).collect();
        let mut settle = |cell: usize, before: bool| {
            let (column, row) = ((cell % width) as i64, (cell / width) as i64);
            let back = if before { -1 } else { 1 };
            for (dx, dy, cost) in
                [(back, 0, STRAIGHT), (-1, back, DIAGONAL), (0, back, STRAIGHT), (1, back, DIAGONAL)]
            {
                let free = self.is_free(column + dx, row + dy);
                let there = if free { room[(cell as i64 + dx + dy * width as i64) as usize] } else { 0 };
                room[cell] = room[cell].min(there.saturating_add(cost));
            }
        };
        (0..cells).filter(|&cell| self.free[cell]).for_each(|cell| settle(cell, true));
        (0..cells).rev().filter(|&cell| self.free[cell]).for_each(|cell| settle(cell, false));
        room
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn floor(rows: &[&str]) -> Floor {
        let free = rows.iter().flat_map(|row| row.chars().map(|letter| letter == '.')).collect();
        Floor { width: rows[0].len(), height: rows.len(), free }
    }

    #[test]
    fn the_roomiest_place_lies_in_the_largest_part() {
        let floor = floor(&["...##........", "...##........", "...##........", "#############"]);
        assert_eq!(floor.roomiest(0.0), Some([6, 1]), "the first of the places with most room");
        assert_eq!(floor.roomiest(2.0), None);
    }

    #[test]
    fn corners_that_touch_are_no_way_through() {
        let mut floor = floor(&["..##", "..##", "##..", "##.."]);
        floor.keep_around([0, 0]);
        assert_eq!(floor.free_pixels(), 4);
        assert!(!floor.is_free(2, 2) && !floor.is_free(-1, 0) && !floor.is_free(0, 4));
    }
}
