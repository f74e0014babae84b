use crate::Act;

/// How near to straight ahead a turn is not worth a word, radians.
const STRAIGHT: f64 = 0.5 / 180.0 * core::f64::consts::PI;

/// What the robot does about a decision, as the end of the sentence that says why; `wanted` is how far it
/// would have gone had nothing been near, metres.
pub(crate) fn deed(act: Act, wanted: f64) -> String {
    match act {
        Act::Arrived | Act::Stuck => String::new(),
        Act::Step { turn, travel: 0.0 } if wanted == 0.0 => {
            format!("; first it turns {} and looks", angle(turn))
        }
        Act::Step { travel: 0.0, .. } => {
            "; something is close before it, so it stands still and looks".to_owned()
        }
        Act::Step { travel, .. } if travel < wanted - 0.05 => {
            format!("; it goes only {} on, for something is near", length(travel))
        }
        Act::Step { turn, travel } if turn.abs() < STRAIGHT => format!("; it goes {} on", length(travel)),
        Act::Step { turn, travel } => format!("; it turns {} and goes {} on", angle(turn), length(travel)),
    }
}

fn angle(turn: f64) -> String {
    let side = if turn < 0.0 { "right" } else { "left" };
    format!("{:.0}° {side}", turn.to_degrees().abs())
}

fn length(travel: f64) -> String {
    if travel < 0.095 { format!("{:.0} cm", 100.0 * travel) } else { format!("{travel:.1} m") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_deed_says_how_far_and_to_which_side() {
        let step = |turn: f64, travel| Act::Step { turn: turn.to_radians(), travel };
        assert_eq!(deed(step(-34.6, 0.0), 0.0), "; first it turns 35° right and looks");
        assert_eq!(deed(step(0.1, 0.8), 0.8), "; it goes 0.8 m on");
        assert_eq!(deed(step(3.0, 0.8), 0.8), "; it turns 3° left and goes 0.8 m on");
        assert_eq!(deed(step(0.0, 0.06), 0.8), "; it goes only 6 cm on, for something is near");
        assert!(deed(step(0.0, 0.0), 0.8).contains("stands still"));
        assert_eq!(deed(Act::Arrived, 0.0), "");
    }
}
