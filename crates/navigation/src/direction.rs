use cogmap_geometry::{DVec2, trig};
use cogmap_mapping::{Sentence, say};
use serde::{Deserialize, Serialize};

use crate::MovementOption;

/// What "the straightest line to the target" means (§3.3.2, Fig. 3.28), which the thesis does not say.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Straightest {
    /// The way over the option's end is the least longer than the straight line: |RO| + |OT| − |RT|, metres.
    #[default]
    Shortest,
    /// The way bends least at the option's end, radians.
    LeastBend,
}

impl Straightest {
    /// How far from straight a way from the robot over an option's end to the target is; lower is better.
    pub(crate) fn score(self, robot: DVec2, end: DVec2, target: DVec2) -> f64 {
        match self {
            Self::Shortest => detour(robot, end, target),
            Self::LeastBend => {
                let (seen, assumed) = (end - robot, target - end);
                trig::atan2(seen.perp_dot(assumed), seen.dot(assumed)).abs()
            }
        }
    }
}

/// Metres that the way over an option's end is longer than the straight line.
pub(crate) fn detour(robot: DVec2, end: DVec2, target: DVec2) -> f64 {
    (robot.distance(end) + end.distance(target) - robot.distance(target)).max(0.0)
}

/// The option that forms the straightest line to the target, of those that are for choice.
pub(crate) fn straightest(options: &[MovementOption]) -> Option<usize> {
    let for_choice = options.iter().enumerate().filter(|(_, option)| !option.barred);
    Some(for_choice.min_by(|a, b| a.1.score.total_cmp(&b.1.score))?.0)
}

/// Why an option was chosen, of so many for choice: one sentence for people.
pub(crate) fn why(option: &MovementOption, choice: usize, robot: DVec2, home: DVec2) -> Sentence {
    let (seen, assumed) = (robot.distance(option.end), option.end.distance(home));
    if option.detour < 0.05 && assumed < 0.05 {
        return say("the straight way home, {} m, is seen to be free", &[(seen, 1)]);
    }
    if option.detour < 0.05 {
        return say(
            "of the straight way home, {} m, the robot sees {} m to be free and hopes for the rest",
            &[(seen + assumed, 1), (seen, 1)],
        );
    }
    let lengths = [(seen, 1), (assumed, 1), (option.detour, 1)];
    if choice == 1 {
        return say(
            "one way on is open: {} m that the robot sees to be free, then it hopes for {} m straight home, {} m \
             more than the beeline",
            &lengths,
        );
    }
    let [seen, assumed, detour] = lengths;
    say(
        "of {} ways on that are open this one makes the straightest way home: {} m that the robot sees to be free, \
         then it hopes for {} m straight home, {} m more than the beeline",
        &[(choice as f64, 0), seen, assumed, detour],
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_two_readings_can_disagree() {
        let (robot, target) = (DVec2::ZERO, DVec2::new(10.0, 0.0));
        // A step aside costs little way but a sharp bend; far out it is the other way round.
        let (aside, far) = (DVec2::new(0.0, 0.5), DVec2::new(5.0, 3.0));
        let better = |reading: Straightest| {
            if reading.score(robot, aside, target) < reading.score(robot, far, target) {
                "aside"
            } else {
                "far"
            }
        };
        assert_eq!((better(Straightest::Shortest), better(Straightest::LeastBend)), ("aside", "far"));
    }

    #[test]
    fn what_is_barred_is_not_chosen() {
        let option = |score, barred| MovementOption { end: DVec2::X, detour: 0.0, score, barred };
        assert_eq!(straightest(&[option(2.0, false), option(1.0, true), option(3.0, false)]), Some(0));
        assert_eq!(straightest(&[option(1.0, true)]), None);
    }
}
