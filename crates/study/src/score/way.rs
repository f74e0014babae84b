use super::{Values, count};
use crate::metrics::{Sample, closing, error_over, length, shape};

/// Lengths of the stretches over which errors are told, metres, with the names of their measures.
pub(crate) const STRETCHES: [(f64, &str); 6] = [
    (2.0, "error_2"),
    (4.0, "error_4"),
    (8.0, "error_8"),
    (16.0, "error_16"),
    (32.0, "error_32"),
    (64.0, "error_64"),
];

/// How well the way is known.
pub(super) fn score(samples: &[Sample], values: &mut Values) {
    let way = length(samples);
    values.put("way", way);
    values.put("steps", count(samples.len().saturating_sub(1)));
    if let Some(shape) = shape(samples) {
        values.put("shape", shape.rms);
        values.put("shape_share", shape.error() * 100.0);
    }
    if let Some(closing) = closing(samples) {
        values.put("gap", closing.gap);
        values.put("gap_share", (way > 0.0).then(|| closing.gap / way * 100.0));
        values.put("heading_gap", closing.heading.to_degrees());
    }
    for (length, name) in STRETCHES {
        values.put(name, error_over(samples, length));
    }
}
