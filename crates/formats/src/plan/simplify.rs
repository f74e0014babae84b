use cogmap_geometry::{DVec2, Segment};

use super::outline::Contour;

/// How far a piece may be from the corners that it replaces, pixels …
const TOLERANCE: f64 = 1.0;
/// … and as a share of the outline's extent, so that a chair's leg stays one.
const SHARE: f64 = 0.1;
/// How many corners are looked at, all rounds together, before a plan counts as too intricate.
const PATIENCE: usize = 400_000_000;

/// Closed lines with as few corners as stay within the tolerance (Douglas–Peucker); `None` where
/// they need more pieces than allowed, or more patience than there is.
pub(super) fn all(contours: &[Contour], pieces_max: usize) -> Option<Vec<Contour>> {
    let (mut patience, mut pieces) = (PATIENCE, 0);
    let mut lines = Vec::with_capacity(contours.len());
    for contour in contours {
        let line = simplified(contour, &mut patience)?;
        pieces += line.len() - 1;
        if pieces > pieces_max {
            return None;
        }
        lines.push(line);
    }
    Some(lines)
}

fn simplified(contour: &Contour, patience: &mut usize) -> Option<Contour> {
    let last = contour.len() - 1;
    let points: Vec<DVec2> =
        contour.iter().map(|&[column, row]| DVec2::new(f64::from(column), f64::from(row))).collect();
    let (far, extent) = farthest(&points, 0, last, |point| point.distance(points[0]));
    let tolerance = TOLERANCE.min(SHARE * extent);
    let mut kept = vec![false; contour.len()];
    for corner in [0, far, last] {
        kept[corner] = true;
    }
    let mut open = vec![[0, far], [far, last]];
    while let Some([from, to]) = open.pop() {
        *patience = patience.checked_sub(to - from)?;
        let piece = Segment::new(points[from], points[to]);
        let (middle, distance) = farthest(&points, from, to, |point| distance(piece, point));
        if distance > tolerance {
            kept[middle] = true;
            open.extend([[from, middle], [middle, to]]);
        }
    }
    let corners = contour.iter().zip(kept);
    let mut line: Contour = corners.filter_map(|(&corner, kept)| kept.then_some(corner)).collect();
    line.dedup();
    Some(line)
}

/// The first of the corners between two that lies farthest, and how far.
fn farthest(points: &[DVec2], from: usize, to: usize, far: impl Fn(DVec2) -> f64) -> (usize, f64) {
    let between = (from + 1..to).map(|corner| (corner, far(points[corner])));
    between.fold((from, 0.0), |best, next| if next.1 > best.1 { next } else { best })
}

fn distance(piece: Segment, point: DVec2) -> f64 {
    let (way, ahead) = (piece.b - piece.a, point - piece.a);
    let along = ahead.dot(way) / way.length_squared();
    // An outline may come back to the same corner: a piece without length.
    if along.is_finite() { ahead.distance(way * along.clamp(0.0, 1.0)) } else { ahead.length() }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_rectangle_keeps_its_four_corners_and_a_small_one_too() {
        for size in [1, 2, 400] {
            let square = vec![[5, 5], [5 + size, 5], [5 + size, 5 + size], [5, 5 + size], [5, 5]];
            assert_eq!(all(std::slice::from_ref(&square), 9).unwrap(), [square]);
        }
    }

    #[test]
    fn stairs_of_pixels_become_a_straight_line() {
        let mut stairs: Contour = (0..50).flat_map(|k| [[k, k], [k + 1, k]]).collect();
        stairs.extend([[50, 50], [0, 50], [0, 0]]);
        assert_eq!(all(&[stairs], 9).unwrap()[0].len(), 4);
    }

    #[test]
    fn more_pieces_than_allowed_are_refused() {
        let square = vec![[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]];
        assert!(all(&[square.clone(), square], 7).is_none());
    }

    proptest! {
        #[test]
        fn no_corner_is_farther_from_the_line_than_a_pixel(
            corners in prop::collection::vec([0u32..60, 0u32..60], 3..40),
        ) {
            let mut contour = corners;
            contour.dedup();
            contour.push(contour[0]);
            prop_assume!(contour.len() > 3 && contour[contour.len() - 2] != contour[0]);
            let line = all(std::slice::from_ref(&contour), 1000).unwrap().remove(0);
            let point = |&[x, y]: &[u32; 2]| DVec2::new(f64::from(x), f64::from(y));
            for corner in contour.iter().map(point) {
                let near = line.windows(2).map(|ends| {
                    distance(Segment::new(point(&ends[0]), point(&ends[1])), corner)
                });
                prop_assert!(near.fold(f64::INFINITY, f64::min) <= 1.0);
            }
            prop_assert_eq!(line.first(), line.last());
        }
    }
}
