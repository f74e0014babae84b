use cogmap_mapping::{Sentence, say};

use crate::Act;

/// How near to straight ahead a turn is not worth a word, radians.
const STRAIGHT: f64 = 0.5 / 180.0 * core::f64::consts::PI;

/// What the robot does about a decision, as the end of the sentence that says why; `wanted` is how far it
/// would have gone had nothing been near, metres.
pub(crate) fn deed(act: Act, wanted: f64) -> Sentence {
    match act {
        Act::Arrived | Act::Stuck => Sentence::default(),
        Act::Step { turn, travel: 0.0 } if wanted == 0.0 => look(turn),
        Act::Step { travel: 0.0, .. } => {
            say("something is close before it, so it stands still and looks", &[])
        }
        Act::Step { travel, .. } if travel < wanted - 0.05 => inch(travel),
        Act::Step { turn, travel } if turn.abs() < STRAIGHT => go(travel),
        Act::Step { turn, travel } => turn_and_go(turn, travel),
    }
}

fn look(turn: f64) -> Sentence {
    if turn < 0.0 {
        say("first it turns {}° right and looks", &[angle(turn)])
    } else {
        say("first it turns {}° left and looks", &[angle(turn)])
    }
}

fn inch(travel: f64) -> Sentence {
    if is_short(travel) {
        say("it goes only {} cm on, for something is near", &[length(travel)])
    } else {
        say("it goes only {} m on, for something is near", &[length(travel)])
    }
}

fn go(travel: f64) -> Sentence {
    if is_short(travel) {
        say("it goes {} cm on", &[length(travel)])
    } else {
        say("it goes {} m on", &[length(travel)])
    }
}

fn turn_and_go(turn: f64, travel: f64) -> Sentence {
    let numbers = [angle(turn), length(travel)];
    match (turn < 0.0, is_short(travel)) {
        (true, true) => say("it turns {}° right and goes {} cm on", &numbers),
        (true, false) => say("it turns {}° right and goes {} m on", &numbers),
        (false, true) => say("it turns {}° left and goes {} cm on", &numbers),
        (false, false) => say("it turns {}° left and goes {} m on", &numbers),
    }
}

/// Degrees.
fn angle(turn: f64) -> (f64, usize) {
    (turn.to_degrees().abs(), 0)
}

/// Whether a length is said in centimetres.
fn is_short(travel: f64) -> bool {
    travel < 0.095
}

/// Centimetres where it is short, metres else.
fn length(travel: f64) -> (f64, usize) {
    if is_short(travel) { (100.0 * travel, 0) } else { (travel, 1) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_deed_says_how_far_and_to_which_side() {
        let step = |turn: f64, travel| Act::Step { turn: turn.to_radians(), travel };
        let deed = |act, wanted| deed(act, wanted).to_string();
        assert_eq!(deed(step(-34.6, 0.0), 0.0), "first it turns 35° right and looks");
        assert_eq!(deed(step(0.1, 0.8), 0.8), "it goes 0.8 m on");
        assert_eq!(deed(step(3.0, 0.8), 0.8), "it turns 3° left and goes 0.8 m on");
        assert_eq!(deed(step(0.0, 0.06), 0.8), "it goes only 6 cm on, for something is near");
        assert!(deed(step(0.0, 0.0), 0.8).contains("stands still"));
        assert_eq!(deed(Act::Arrived, 0.0), "");
    }
}
