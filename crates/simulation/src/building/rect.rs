/// A rectangle of floor along the axes, corners on whole centimetres: x first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Rect {
    pub(super) low: [i32; 2],
    pub(super) high: [i32; 2],
}

impl Rect {
    pub(super) fn new(x: [i32; 2], y: [i32; 2]) -> Self {
        Self { low: [x[0], y[0]], high: [x[1], y[1]] }
    }

    /// The rectangle that reaches over `along` on one axis and over `across` on the other.
    pub(super) fn on(axis: usize, along: [i32; 2], across: [i32; 2]) -> Self {
        if axis == 0 { Self::new(along, across) } else { Self::new(across, along) }
    }

    /// From and to on an axis.
    pub(super) fn span(&self, axis: usize) -> [i32; 2] {
        [self.low[axis], self.high[axis]]
    }

    pub(super) fn size(&self, axis: usize) -> i32 {
        self.high[axis] - self.low[axis]
    }

    /// The shorter and the longer side.
    pub(super) fn sides(&self) -> [i32; 2] {
        let [a, b] = [self.size(0), self.size(1)];
        [a.min(b), a.max(b)]
    }

    /// Square metres.
    pub(super) fn area(&self) -> f64 {
        f64::from(self.size(0)) * f64::from(self.size(1)) / 1e4
    }

    /// What both have in common on an axis, if that is anything.
    pub(super) fn shared(&self, other: &Self, axis: usize) -> Option<[i32; 2]> {
        let span = [self.low[axis].max(other.low[axis]), self.high[axis].min(other.high[axis])];
        (span[0] < span[1]).then_some(span)
    }

    pub(super) fn overlaps(&self, other: &Self) -> bool {
        self.shared(other, 0).is_some() && self.shared(other, 1).is_some()
    }

    pub(super) fn grown(&self, by: i32) -> Self {
        Self { low: self.low.map(|c| c - by), high: self.high.map(|c| c + by) }
    }

    /// The same floor seen in a mirror: `swap` changes x for y, `flip` turns an axis round.
    pub(super) fn mirrored(&self, swap: bool, flip: [bool; 2]) -> Self {
        let axes = if swap { [1, 0] } else { [0, 1] };
        let [x, y] = axes.map(|axis| {
            let [low, high] = self.span(axis);
            if flip[axis] { [-high, -low] } else { [low, high] }
        });
        Self::new(x, y)
    }

    pub(super) fn moved(&self, by: [i32; 2]) -> Self {
        Self { low: add(self.low, by), high: add(self.high, by) }
    }
}

fn add(a: [i32; 2], b: [i32; 2]) -> [i32; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

/// Centimetres as metres.
pub(super) fn metres(point: [i32; 2]) -> [f64; 2] {
    point.map(|c| f64::from(c) / 100.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rectangles_side_by_side_share_an_edge_and_do_not_overlap() {
        let (left, right) = (Rect::new([0, 300], [0, 200]), Rect::new([300, 500], [50, 400]));
        assert_eq!((left.shared(&right, 0), left.shared(&right, 1)), (None, Some([50, 200])));
        assert!(!left.overlaps(&right) && left.grown(1).overlaps(&right));
        assert_eq!(right.sides(), [200, 350]);
    }

    #[test]
    fn a_mirror_keeps_the_size_and_a_swap_turns_it() {
        let room = Rect::new([0, 300], [10, 200]);
        assert_eq!(room.mirrored(false, [true, false]), Rect::new([-300, 0], [10, 200]));
        assert_eq!(room.mirrored(true, [false, false]), Rect::new([10, 200], [0, 300]));
    }
}
