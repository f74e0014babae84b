use crate::Colour;

/// Colours over a run, first view to last: equal steps to the eye (arc length in OKLab), lightness
/// only ever rising, hues from violet over teal to amber, which the colour-blind keep apart.
pub(crate) struct Ramp(pub(crate) [u32; 17]);

impl Ramp {
    /// The colour a share of the way through the run.
    pub(crate) fn at(&self, share: f64) -> Colour {
        let Self(stops) = self;
        let scaled = share.clamp(0.0, 1.0) * (stops.len() - 1) as f64;
        let below = (scaled as usize).min(stops.len() - 2);
        match stops.get(below..) {
            Some(&[from, to, ..]) => Colour::solid(from).towards(Colour::solid(to), scaled - below as f64),
            _ => Colour::solid(0),
        }
    }
}

/// For a light ground: dark violet to amber, all dark enough for 3:1.
pub(crate) const ON_LIGHT: Ramp = Ramp([
    0x2f0474, 0x231681, 0x042788, 0x023378, 0x043e6b, 0x054965, 0x065563, 0x086161, 0x0a6c5c, 0x0c7651,
    0x0d7e3e, 0x1b841d, 0x50830c, 0x70830d, 0x8b830f, 0xa48310, 0xbc8211,
]);

/// For a dark ground: violet to light yellow, all light enough for 3:1.
pub(crate) const ON_DARK: Ramp = Ramp([
    0x7157be, 0x6565cc, 0x5474d7, 0x3c83dd, 0x1391df, 0x159dd4, 0x17a9cd, 0x19b6c6, 0x1cc2bf, 0x1eceb6,
    0x1fd9a9, 0x59df99, 0x84e489, 0xa9e779, 0xcae96c, 0xeaea63, 0xfeea70,
]);

/// A longer run has only so many colours, so that surfaces of neighbouring views can be painted together.
const RUN_COLOURS: usize = 64;

/// How far through a run of so many views a view is, from 0 to 1.
pub(crate) fn share_of_run(view: usize, views: usize) -> f64 {
    let views = views.max(2);
    let colours = views.min(RUN_COLOURS);
    (view * colours / views) as f64 / (colours - 1) as f64
}
