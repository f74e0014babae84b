use cogmap_geometry::{DVec2, normalize_angle, trig};

use crate::strategy::{Situation, Wish};

/// Directions beside the wanted one that are tried lie so far apart, radians.
const APART: f64 = 3.0 * trig::PI / 180.0;
/// A stretch that is long enough to go for, metres.
const ENOUGH: f64 = 0.4;
/// The shortest stretch that is worth a look aside, metres.
const LEAST: f64 = 0.1;

/// Goes toward the first corner of a way; where the scans say that this is too tight, a little to the
/// side of it, at most by so many radians. `None` where that is not possible either.
pub(crate) fn toward(situation: &Situation, corners: &[DVec2], aside_max: f64) -> Option<Wish> {
    let here = situation.belief.here_from_robot;
    let corner =
        *corners.iter().find(|corner| corner.distance(here.position) >= situation.params.step_min)?;
    let ahead = corner - here.position;
    let wanted = ahead.length().min(situation.params.step_max);
    let bearing = trig::atan2(ahead.y, ahead.x);
    let turn = normalize_angle(bearing - here.heading);
    if turn.abs() > trig::FRAC_PI_2 - APART
        || situation.vigilance.free_way(turn, wanted) >= wanted.min(ENOUGH)
    {
        return Some(Wish::GoTo(corner));
    }
    let mut best: Option<(f64, f64)> = None;
    #[allow(clippy::cast_possible_truncation, reason = "a circle has 120 of them")]
    for k in 1..=(aside_max / APART) as i32 {
        for side in [-1.0, 1.0] {
            let aside = side * f64::from(k) * APART;
            let free = situation.vigilance.free_way(turn + aside, wanted);
            if free >= wanted.min(ENOUGH) {
                return Some(go(situation, bearing + aside, free));
            }
            if free >= LEAST && best.is_none_or(|(most, _)| free > most + 0.05) {
                best = Some((free, aside));
            }
        }
    }
    best.map(|(free, aside)| go(situation, bearing + aside, free))
}

fn go(situation: &Situation, bearing: f64, way: f64) -> Wish {
    let (sin, cos) = trig::sin_cos(bearing);
    Wish::GoTo(situation.belief.here_from_robot.position + DVec2::new(cos, sin) * way)
}
