use cogmap_geometry::{DVec2, Segment};

use crate::{Bounds, Item, Scene, Shape, clip::clip};

impl Scene {
    /// What of it lies within a rectangle: a close-up. Lines are cut at its edge; areas are kept where all of
    /// them lies within, and robots, signs and words where their middle does.
    #[must_use]
    pub fn within(mut self, bounds: Bounds) -> Self {
        for items in [&mut self.still, &mut self.changing] {
            let all = std::mem::take(items).into_iter();
            let cut =
                |item: Item| item.shape.within(bounds).into_iter().map(move |it| Item::new(item.role, it));
            items.extend(all.flat_map(cut));
        }
        self
    }
}

impl Bounds {
    fn holds(self, point: DVec2) -> bool {
        point.cmpge(self.min).all() && point.cmple(self.max).all()
    }

    /// The part of a line within.
    fn cut(self, from: DVec2, to: DVec2) -> Option<[DVec2; 2]> {
        let line = clip([from - self.min, to - self.min], self.max - self.min, 0.0)?;
        Some(line.map(|end| end + self.min))
    }
}

impl Shape {
    fn within(self, bounds: Bounds) -> Vec<Self> {
        let holds = |point: DVec2| bounds.holds(point);
        let kept = |keep: bool, shape: Self| if keep { vec![shape] } else { Vec::new() };
        match self {
            Self::Segments(lines) => {
                let cut = lines.iter().filter_map(|line| bounds.cut(line.a, line.b));
                let cut: Vec<Segment> = cut.map(|[a, b]| Segment::new(a, b)).collect();
                kept(!cut.is_empty(), Self::Segments(cut))
            }
            Self::Polyline(points) => pieces(&points, bounds).into_iter().map(Self::Polyline).collect(),
            Self::Arrow(points) => {
                let head = points.last().copied();
                let piece = |piece: Vec<DVec2>| {
                    if piece.last().copied() == head { Self::Arrow(piece) } else { Self::Polyline(piece) }
                };
                pieces(&points, bounds).into_iter().map(piece).collect()
            }
            Self::Signs(places) => {
                let places: Vec<DVec2> = places.into_iter().filter(|&place| holds(place)).collect();
                kept(!places.is_empty(), Self::Signs(places))
            }
            Self::Polygon(corners) => {
                kept(corners.iter().all(|&corner| holds(corner)), Self::Polygon(corners))
            }
            Self::Disc(at, radius) => kept(holds(at - radius) && holds(at + radius), Self::Disc(at, radius)),
            Self::Robot(pose, radius) => kept(holds(pose.position), Self::Robot(pose, radius)),
            Self::Label { at, .. } => kept(holds(at), self),
        }
    }
}

/// A line through points, cut at the edge of a rectangle.
fn pieces(points: &[DVec2], bounds: Bounds) -> Vec<Vec<DVec2>> {
    let mut pieces: Vec<Vec<DVec2>> = Vec::new();
    for pair in points.windows(2) {
        let Some([from, to]) = bounds.cut(pair[0], pair[1]) else { continue };
        match pieces.last_mut() {
            Some(piece) if piece.last() == Some(&from) => piece.push(to),
            _ => pieces.push(vec![from, to]),
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{HomingMark, Role};

    const BOUNDS: Bounds = Bounds { min: DVec2::new(-1.0, -1.0), max: DVec2::new(3.0, 2.0) };

    fn within(shape: Shape) -> Vec<Shape> {
        let still = vec![Item::new(Role::Homing(HomingMark::Chosen), shape)];
        let cut = Scene { still, ..Scene::default() }.within(BOUNDS);
        cut.still.into_iter().map(|item| item.shape).collect()
    }

    #[test]
    fn a_line_that_leaves_and_comes_back_is_cut_in_two() {
        let [a, b, c, d] = [[0.0, 0.0], [0.0, 4.0], [2.0, 4.0], [2.0, 0.0]].map(DVec2::from);
        let [out, back] = [DVec2::new(0.0, 2.0), DVec2::new(2.0, 2.0)];
        let pieces = within(Shape::Polyline(vec![a, b, c, d]));
        assert_eq!(pieces, [Shape::Polyline(vec![a, out]), Shape::Polyline(vec![back, d])]);
    }

    #[test]
    fn an_arrow_keeps_its_head_only_where_the_head_is_within() {
        let [a, b, c] = [[0.0, 0.0], [1.0, 0.0], [5.0, 0.0]].map(DVec2::from);
        assert_eq!(within(Shape::Arrow(vec![c, b, a]))[0], Shape::Arrow(vec![DVec2::new(3.0, 0.0), b, a]));
        assert_eq!(within(Shape::Arrow(vec![a, b, c])), [Shape::Polyline(vec![a, b, DVec2::new(3.0, 0.0)])]);
    }

    #[test]
    fn what_lies_beyond_leaves_nothing() {
        let [a, b] = [[7.0, 0.0], [9.0, 9.0]].map(DVec2::from);
        for shape in [Shape::Polyline(vec![a, b]), Shape::Signs(vec![a]), Shape::Disc(a, 0.5)] {
            assert_eq!(within(shape), []);
        }
    }
}
