use cogmap_geometry::{DVec2, Segment};
use cogmap_scene::{Annotation, Item, Shape};

use super::draw::{lines, role, word};

/// A curve in a frame with axes, laid out in metres of the picture so that it can stand beside scenes.
pub(super) struct Plot {
    /// Lower left corner and size in the picture, metres.
    pub(super) corner: DVec2,
    pub(super) size: DVec2,
    /// The values at the corner and opposite to it.
    pub(super) from: DVec2,
    pub(super) to: DVec2,
}

impl Plot {
    /// Where values appear in the picture.
    pub(super) fn place(&self, value: DVec2) -> DVec2 {
        self.corner + (value - self.from) / (self.to - self.from) * self.size
    }

    /// Frame, grid and numbers; `x` and `y` list the ticks with their texts.
    pub(super) fn axes(&self, x: &[(f64, String)], y: &[(f64, String)], names: [&str; 2]) -> Vec<Item> {
        let gap = 0.045 * self.size.max_element();
        let vertical = |value: f64| [self.from.y, self.to.y].map(|y| self.place(DVec2::new(value, y)));
        let horizontal = |value: f64| [self.from.x, self.to.x].map(|x| self.place(DVec2::new(x, value)));
        let line = |[a, b]: [DVec2; 2]| Segment::new(a, b);
        let grid = x.iter().map(|(value, _)| line(vertical(*value)));
        let grid = grid.chain(y.iter().map(|(value, _)| line(horizontal(*value))));
        let axes = [line(vertical(self.from.x)), line(horizontal(self.from.y))];
        let mut items = vec![lines(role(Annotation::Grid), grid), lines(role(Annotation::Axis), axes)];
        let below = |value: f64| vertical(value)[0] - DVec2::new(0.0, gap);
        let beside = |value: f64| horizontal(value)[0] - DVec2::new(gap * 1.8, 0.0);
        items.extend(x.iter().map(|(value, text)| word(below(*value), text.clone())));
        items.extend(y.iter().map(|(value, text)| word(beside(*value), text.clone())));
        let end = self.corner + self.size;
        let middle = self.corner + self.size * 0.5;
        items.push(word(DVec2::new(middle.x, self.corner.y - 2.3 * gap), names[0]));
        items.push(word(DVec2::new(self.corner.x + 0.1 * self.size.x, end.y + gap), names[1]));
        items
    }

    /// A curve through values.
    pub(super) fn curve(&self, values: impl IntoIterator<Item = DVec2>) -> Item {
        let points = values.into_iter().map(|value| self.place(value)).collect();
        Item::new(role(Annotation::Curve), Shape::Polyline(points))
    }

    /// Values that matter.
    pub(super) fn marks(&self, values: impl IntoIterator<Item = DVec2>) -> Item {
        let points = values.into_iter().map(|value| self.place(value)).collect();
        Item::new(role(Annotation::Mark), Shape::Signs(points))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_appear_between_the_corners_and_every_tick_is_written() {
        let (corner, size) = (DVec2::new(1.0, 2.0), DVec2::new(4.0, 3.0));
        let plot = Plot { corner, size, from: DVec2::new(-10.0, 0.0), to: DVec2::new(10.0, 6.0) };
        assert_eq!(plot.place(plot.from), corner);
        assert_eq!(plot.place(plot.to), corner + size);
        assert_eq!(plot.place(DVec2::new(0.0, 3.0)), corner + size * 0.5);
        let ticks = [(0.0, "0".to_owned()), (5.0, "5".to_owned())];
        let items = plot.axes(&ticks, &ticks, ["x", "y"]);
        let words = items.iter().filter(|item| matches!(item.shape, Shape::Label { .. }));
        assert_eq!(words.count(), 2 + 2 + 2);
    }
}
