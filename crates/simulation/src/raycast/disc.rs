use cogmap_geometry::DVec2;

/// A round solid: a chair leg, a post, a person.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Middle, metres.
    pub center: DVec2,
    /// Metres; a beam from inside meets the far side.
    pub radius: f64,
}
