use cogmap_geometry::trig;
use rand_core::Rng;
use rand_pcg::Pcg64Mcg;
use serde::{Deserialize, Serialize};

/// How the movement is corrected (§3.1.3): random changes, kept only when the error drops, by an
/// ever smaller margin.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Annealing {
    /// Changes to try.
    pub iterations: u32,
    /// Largest change of the turn to begin with, radians.
    pub turn: f64,
    /// Largest change of the distance travelled to begin with, metres.
    pub travel: f64,
    /// What the margins shrink to with each try, as a factor.
    pub shrink: f64,
    /// The error that a pair counts with at most, and that a surface counts with that has no partner,
    /// m² rad: both ends about 0.2 m off and turned by 1°, or 0.1 m and 5°.
    pub worst: f64,
}

impl Default for Annealing {
    fn default() -> Self {
        Self { iterations: 400, turn: 10.0 * trig::PI / 180.0, travel: 0.2, shrink: 0.99, worst: 0.0025 }
    }
}

/// What a search came to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Correction {
    /// Added to the turn, radians.
    pub turn: f64,
    /// Added to the distance travelled, metres.
    pub travel: f64,
    /// The mean matching error to begin with and after each change that was kept; never rises.
    pub errors: Vec<f64>,
}

/// Looks for the changes of turn and travel with the least error, beginning with none.
pub fn anneal(error_of: impl Fn(f64, f64) -> f64, params: &Annealing, rng: &mut Pcg64Mcg) -> Correction {
    let mut best = Correction { turn: 0.0, travel: 0.0, errors: vec![error_of(0.0, 0.0)] };
    let (mut turn_margin, mut travel_margin) = (params.turn, params.travel);
    for _ in 0..params.iterations {
        let turn = best.turn + turn_margin * signed(rng);
        let travel = best.travel + travel_margin * signed(rng);
        let error = error_of(turn, travel);
        if best.errors.last().is_some_and(|least| error < *least) {
            (best.turn, best.travel) = (turn, travel);
            best.errors.push(error);
        }
        turn_margin *= params.shrink;
        travel_margin *= params.shrink;
    }
    best
}

/// A number from `[-1, 1)`, all alike.
#[allow(clippy::cast_precision_loss, reason = "53 bits fit exactly")]
fn signed(rng: &mut Pcg64Mcg) -> f64 {
    (rng.next_u64() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use rand_core::SeedableRng;

    use super::*;

    proptest! {
        #[test]
        fn the_error_never_rises_and_the_minimum_is_found(turn in -0.1f64..0.1, travel in -0.15f64..0.15, seed: u64) {
            let bowl = |t: f64, x: f64| (t - turn).abs() + (x - travel).abs();
            let found = anneal(bowl, &Annealing::default(), &mut Pcg64Mcg::seed_from_u64(seed));
            prop_assert!(found.errors.windows(2).all(|pair| pair[1] < pair[0]));
            prop_assert!(bowl(found.turn, found.travel) < 0.05);
        }
    }

    #[test]
    fn the_same_seed_finds_the_same() {
        let run = || anneal(|t, x| t * t + x, &Annealing::default(), &mut Pcg64Mcg::seed_from_u64(3));
        assert_eq!(run(), run());
    }
}
