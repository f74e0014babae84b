use super::Values;
use crate::home::{Ended, Trial};

/// Home is reached within this, metres: more than the metre by which a way home of the thesis missed its
/// start (§3.3.5), which it counts as reached.
const HOME: f64 = 1.5;

/// How a way home went; `None` where the way out could not be driven.
pub(crate) fn score_way_home(trial: Option<&Trial>) -> Values {
    let mut values = Values::default();
    let truth = |is_so: bool| f64::from(u8::from(is_so));
    values.put("arrived", truth(trial.is_some()));
    let Some(trial) = trial else { return values };
    let reached = trial.succeeds(HOME);
    values.put("home_reached", truth(reached));
    values.put("home_distance", trial.distance);
    values.put("help_needed", truth(trial.ended != Ended::Home));
    values.put("shortcut_taken", trial.takes_shortcut(HOME).map(truth));
    values.put("dead_ends", trial.dead_ends);
    values.put("dead_ends_left", (trial.dead_ends > 0.0).then(|| truth(reached)));
    values.put("home_collided", truth(trial.collisions > 0.0));
    values
}
