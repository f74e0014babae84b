use std::collections::BTreeMap;

use super::rect::Rect;

/// The outlines of the floor that rectangles cover together: closed lines, the floor on their left.
pub(super) fn outlines(rects: &[Rect]) -> Vec<Vec<[i32; 2]>> {
    let lines = [0, 1].map(|axis| {
        let mut lines: Vec<i32> = rects.iter().flat_map(|rect| rect.span(axis)).collect();
        lines.sort_unstable();
        lines.dedup();
        lines
    });
    closed(edges(&covered(rects, &lines), &lines))
}

/// Which fields of the grid of all edges are floor, row by row, with an empty field all around.
fn covered(rects: &[Rect], lines: &[Vec<i32>; 2]) -> Vec<Vec<bool>> {
    let mut fields = vec![vec![false; lines[0].len() + 1]; lines[1].len() + 1];
    let index = |axis: usize, at: i32| lines[axis].partition_point(|line| *line < at) + 1;
    for rect in rects {
        let [columns, rows] = [0, 1].map(|axis| index(axis, rect.low[axis])..index(axis, rect.high[axis]));
        for row in fields.iter_mut().take(rows.end).skip(rows.start) {
            row.iter_mut().take(columns.end).skip(columns.start).for_each(|field| *field = true);
        }
    }
    fields
}

/// The edges between floor and no floor, by where they begin; where two begin the first to be used is
/// the last in the list.
fn edges(fields: &[Vec<bool>], lines: &[Vec<i32>; 2]) -> BTreeMap<[i32; 2], Vec<[i32; 2]>> {
    let mut edges: BTreeMap<[i32; 2], Vec<[i32; 2]>> = BTreeMap::new();
    let [xs, ys] = lines;
    for (row, pair) in fields.windows(2).enumerate() {
        for (column, (below, above)) in pair[0].iter().zip(&pair[1]).enumerate() {
            if below != above && column > 0 {
                let [a, b] = [[xs[column - 1], ys[row]], [xs[column], ys[row]]];
                let (from, to) = if *above { (a, b) } else { (b, a) };
                edges.entry(from).or_default().push(to);
            }
        }
    }
    for (row, fields) in fields.iter().enumerate().skip(1) {
        for (column, pair) in fields.windows(2).enumerate() {
            if pair[0] != pair[1] {
                let [a, b] = [[xs[column], ys[row - 1]], [xs[column], ys[row]]];
                let (from, to) = if pair[0] { (a, b) } else { (b, a) };
                edges.entry(from).or_default().push(to);
            }
        }
    }
    edges
}

/// Follows the edges round, and leaves out the points that are no corners.
fn closed(mut edges: BTreeMap<[i32; 2], Vec<[i32; 2]>>) -> Vec<Vec<[i32; 2]>> {
    let mut outlines = Vec::new();
    while let Some((&start, _)) = edges.first_key_value() {
        let mut outline = vec![start];
        let mut at = start;
        while let Some(ends) = edges.get_mut(&at) {
            let Some(next) = ends.pop() else { break };
            if ends.is_empty() {
                edges.remove(&at);
            }
            outline.push(next);
            at = next;
            if at == start {
                break;
            }
        }
        outlines.push(corners(&outline));
    }
    outlines
}

fn corners(outline: &[[i32; 2]]) -> Vec<[i32; 2]> {
    let points = &outline[..outline.len() - 1];
    let count = points.len();
    let is_corner = |k: &usize| {
        let [before, here, after] = [(k + count - 1) % count, *k, (k + 1) % count].map(|k| points[k]);
        (0..2).all(|axis| !(before[axis] == here[axis] && here[axis] == after[axis]))
    };
    let mut corners: Vec<[i32; 2]> = (0..count).filter(is_corner).map(|k| points[k]).collect();
    corners.extend(corners.first().copied());
    corners
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_rooms_and_a_doorway_have_one_outline_of_twelve_corners() {
        let rooms = [
            Rect::new([0, 300], [0, 400]),
            Rect::new([312, 600], [0, 400]),
            Rect::new([300, 312], [50, 140]),
        ];
        let outlines = outlines(&rooms);
        assert_eq!((outlines.len(), outlines[0].len()), (1, 13), "{outlines:?}");
        assert_eq!(outlines[0].first(), outlines[0].last());
    }

    #[test]
    fn a_ring_has_an_outer_and_an_inner_outline() {
        let ring = [
            Rect::new([0, 900], [0, 200]),
            Rect::new([0, 900], [700, 900]),
            Rect::new([0, 200], [200, 700]),
            Rect::new([700, 900], [200, 700]),
        ];
        let found = outlines(&ring);
        assert_eq!(found.iter().map(Vec::len).collect::<Vec<_>>(), [5, 5]);
        let area = |line: &[[i32; 2]]| {
            line.windows(2).map(|e| i64::from(e[0][0] * e[1][1] - e[1][0] * e[0][1])).sum::<i64>() / 2
        };
        assert_eq!([area(&found[0]), area(&found[1])], [900 * 900, -500 * 500], "floor on the left");
    }
}
