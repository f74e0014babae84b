use cogmap_geometry::DVec2;

/// One of four views from the fan's origin, turned so that the quadrant's axis
/// points ahead: x is the depth, y is to the left.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    origin: DVec2,
    quadrant: u8,
}

impl Frame {
    pub(super) fn new(origin: DVec2, quadrant: u8) -> Self {
        Self { origin, quadrant }
    }

    /// Where the beams start.
    pub(super) fn origin(self) -> DVec2 {
        self.origin
    }

    /// A point of the world as seen from here.
    pub(super) fn point(self, point: DVec2) -> DVec2 {
        self.vector(point - self.origin)
    }

    /// A direction of the world as seen from here.
    pub(super) fn vector(self, v: DVec2) -> DVec2 {
        match self.quadrant {
            0 => v,
            1 => DVec2::new(v.y, -v.x),
            2 => -v,
            _ => DVec2::new(-v.y, v.x),
        }
    }

    /// The world's axis that depth runs along: 0 for x, 1 for y.
    pub(super) fn axis(self) -> usize {
        usize::from(self.quadrant % 2)
    }

    /// Whether depth grows against the world's axis, and whether left
    /// does.
    pub(super) fn mirrored(self) -> [bool; 2] {
        [self.quadrant >= 2, self.quadrant == 1 || self.quadrant == 2]
    }
}
