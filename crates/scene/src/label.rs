use cogmap_geometry::DVec2;

/// Where a room has most room for its name: the middle of its widest horizontal chord, and the
/// chord's length in metres; of equals the one nearest to the middle of its height.
pub(crate) fn label_place(outline: &[DVec2]) -> Option<(DVec2, f64)> {
    let low = outline.iter().map(|corner| corner.y).reduce(f64::min)?;
    let high = outline.iter().map(|corner| corner.y).reduce(f64::max)?;
    let mut best: Option<(DVec2, f64)> = None;
    for share in SHARES {
        let y = low + (high - low) * share;
        for (left, right) in chords(outline, y) {
            let width = right - left;
            if best.is_none_or(|(_, widest)| width > widest * 1.01) {
                best = Some((DVec2::new((left + right) * 0.5, y), width));
            }
        }
    }
    best
}

/// Heights tried, from the middle outwards.
const SHARES: [f64; 9] = [0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82];

/// Where a horizontal line runs inside the outline.
fn chords(outline: &[DVec2], y: f64) -> Vec<(f64, f64)> {
    let next = outline.iter().cycle().skip(1);
    let mut crossings: Vec<f64> = outline
        .iter()
        .zip(next)
        .filter(|(a, b)| (a.y > y) != (b.y > y))
        .map(|(a, b)| a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y))
        .filter(|x| x.is_finite())
        .collect();
    crossings.sort_by(f64::total_cmp);
    crossings.chunks_exact(2).filter_map(|pair| Some((*pair.first()?, *pair.last()?))).collect()
}

/// A number of things, such as `1 view` or `2 views`.
pub(crate) fn plural(count: usize, thing: &str) -> String {
    if count == 1 { format!("1 {thing}") } else { format!("{count} {thing}s") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outline(corners: &[[f64; 2]]) -> Vec<DVec2> {
        corners.iter().copied().map(DVec2::from).collect()
    }

    #[test]
    fn a_rectangle_bears_its_name_in_the_middle() {
        let room = outline(&[[1.0, 1.0], [5.0, 1.0], [5.0, 3.0], [1.0, 3.0]]);
        assert_eq!(label_place(&room), Some((DVec2::new(3.0, 2.0), 4.0)));
    }

    #[test]
    fn the_name_of_a_bent_room_stands_inside_it() {
        let room = outline(&[[0.0, 0.0], [6.0, 0.0], [6.0, 2.0], [1.0, 2.0], [1.0, 5.0], [0.0, 5.0]]);
        let (at, width) = label_place(&room).unwrap();
        assert!(at.y < 2.0, "{at}");
        assert!((width - 6.0).abs() < 1e-12);
    }

    #[test]
    fn a_room_without_area_has_no_place_for_a_name() {
        assert_eq!(label_place(&[]), None);
        assert_eq!(label_place(&outline(&[[1.0, 1.0], [2.0, 1.0]])), None);
        assert_eq!(label_place(&outline(&[[f64::NAN, 1.0], [2.0, f64::NAN], [0.0, 0.0]])), None);
    }
}
