use cogmap_geometry::trig::{self, TAU};
use rand_core::Rng;
use rand_pcg::Pcg64Mcg;

/// A number from `[0, 1)`, all alike.
#[allow(clippy::cast_precision_loss, reason = "53 bits fit exactly")]
pub(crate) fn uniform(rng: &mut Pcg64Mcg) -> f64 {
    const SHARE: f64 = 1.0 / (1_u64 << 53) as f64;
    (rng.next_u64() >> 11) as f64 * SHARE
}

/// A number from the normal distribution with mean 0 and variance 1 (Box and Muller).
pub(crate) fn gaussian(rng: &mut Pcg64Mcg) -> f64 {
    let radius = (-2.0 * trig::ln(1.0 - uniform(rng))).sqrt();
    radius * trig::cos(TAU * uniform(rng))
}

#[cfg(test)]
mod tests {
    use rand_core::SeedableRng;

    use super::*;

    #[test]
    fn gaussian_numbers_have_mean_0_and_variance_1() {
        let mut rng = Pcg64Mcg::seed_from_u64(7);
        let numbers: Vec<f64> = (0..100_000).map(|_| gaussian(&mut rng)).collect();
        let mean = numbers.iter().sum::<f64>() / 1e5;
        let variance = numbers.iter().map(|n| n * n).sum::<f64>() / 1e5;
        let within_one = numbers.iter().filter(|n| n.abs() < 1.0).count();
        assert!(mean.abs() < 0.01 && (variance - 1.0).abs() < 0.02, "{mean} {variance}");
        assert!((67_500..69_000).contains(&within_one), "{within_one}");
    }
}
