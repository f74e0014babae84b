//! What is plotted along a run: how wide it was, how far off each mapper is, how much it remembers.

mod curves;

use js_sys::Float64Array;
use serde::{Serialize, Serializer};
use tsify::Tsify;

pub(crate) use self::curves::Curves;
use crate::views::View;

/// What can be plotted of a run, as far as it has ever come.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Tsify)]
pub struct Plots {
    /// One a mapper, in the order of the memories.
    pub curves: Vec<Curve>,
}

/// What one mapper made of a run: a value for each view.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct Curve {
    /// The view of the page that shows its memory.
    pub view: View,
    /// The mapper.
    pub mapper: String,
    /// When each view was taken, seconds since the beginning.
    #[serde(serialize_with = "typed")]
    #[tsify(type = "Float64Array")]
    pub times: Vec<f64>,
    /// Where the run stands when it has just been taken, ticks or readings.
    #[serde(serialize_with = "typed")]
    #[tsify(type = "Float64Array")]
    pub positions: Vec<f64>,
    /// How many surfaces were remembered then.
    #[serde(serialize_with = "typed")]
    #[tsify(type = "Float64Array")]
    pub surfaces: Vec<f64>,
    /// How far off the robot was; nothing where the truth is not known.
    pub off: Option<OffCurve>,
    /// How wide it was on the way; nothing for a mapper that does not know what a space is.
    pub wideness: Option<WidenessCurve>,
}

/// How far a robot is from where it believes it is, a value for each view: the measures `gap` and
/// `heading_gap` of a study, taken at every view. The frames of map and world meet at the first.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Tsify)]
pub struct OffCurve {
    /// Metres.
    #[serde(serialize_with = "typed")]
    #[tsify(type = "Float64Array")]
    pub metres: Vec<f64>,
    /// Degrees, never negative.
    #[serde(serialize_with = "typed")]
    #[tsify(type = "Float64Array")]
    pub degrees: Vec<f64>,
}

/// How wide it was along the way (§3.2.2, Fig. 3.14), each 0.1 m.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Tsify)]
pub struct WidenessCurve {
    /// Seconds since the beginning; shared out evenly between one view and the next.
    #[serde(serialize_with = "typed")]
    #[tsify(type = "Float64Array")]
    pub times: Vec<f64>,
    /// From what is on the left to what is on the right, metres.
    #[serde(serialize_with = "typed")]
    #[tsify(type = "Float64Array")]
    pub metres: Vec<f64>,
    /// The narrow places that are exits, in the order of going through.
    pub exits: Vec<Narrow>,
}

/// A narrow place on the way through which the robot went over into another local space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct Narrow {
    /// When the robot was in it, seconds since the beginning.
    pub t: f64,
    /// How wide it was there, metres.
    pub metres: f64,
    /// The exit.
    pub exit: u32,
    /// The local space behind it, by the name that it had then.
    pub asr: u32,
    /// Whether it became an exit there and then; else the robot knew it and went through again.
    pub found: bool,
    /// Where the run stands when the robot has just noticed, ticks or readings.
    pub position: f64,
}

/// Numbers cross to the page as a typed array.
fn typed<S: Serializer>(numbers: &[f64], serializer: S) -> Result<S::Ok, S::Error> {
    serde_wasm_bindgen::preserve::serialize(&Float64Array::from(numbers), serializer)
}
