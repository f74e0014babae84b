//! What a laser's beams meet first, for a whole scan at once.
//!
//! Instead of following each beam through the world, the solids around the
//! sensor are laid onto the fan of beams: [`RayGrid`] visits the columns of a
//! uniform grid front to back, lays each solid it finds onto the beams between
//! the solid's two ends, and follows only the beams that still see past what
//! was found so far.
//!
//! Only `+ - * /` and `sqrt` touch a beam after its direction is known, so that
//! the ranges have the same bits on every platform.

mod beams;
mod cells;
mod disc;
mod fan;
mod frame;
mod grid;
mod outlook;
mod solid;
mod sweep;

pub use disc::Disc;
pub use fan::Fan;
pub use grid::RayGrid;

/// What a beam meets first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Metres from the fan's origin.
    pub range: f64,
    /// Which solid: the grid's segments count first, then its discs, then the
    /// moving segments and the moving discs of the cast.
    pub solid: u32,
    /// Cosine of the angle between the beam and the solid's normal, `[0, 1]`:
    /// 1 where the beam meets it squarely, 0 where it grazes.
    pub incidence_cos: f64,
}

#[cfg(test)]
mod tests;
