//! What a set of measurements knows about a pose: a 3 × 3 matrix and its principal directions.

/// A step of Gauss and Newton.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub(super) by: [f64; 3],
    /// How many directions of the pose are determined.
    pub(super) rank: usize,
    /// A direction that is not.
    pub(super) open: Option<[f64; 3]>,
}

/// Sum of weighted outer products, and the step that they ask for.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Information {
    matrix: [[f64; 3]; 3],
    pull: [f64; 3],
}

impl Information {
    /// Adds a residual with its gradient and weight.
    pub(super) fn add(&mut self, gradient: [f64; 3], residual: f64, weight: f64) {
        for row in 0..3 {
            self.pull[row] -= weight * gradient[row] * residual;
            for column in 0..3 {
                self.matrix[row][column] += weight * gradient[row] * gradient[column];
            }
        }
    }

    /// The Gauss–Newton step within the directions that are known better than `least`, and better
    /// than that share of the best known one.
    pub(super) fn step(&self, least: f64, share: f64) -> Step {
        let (values, vectors) = eigen(self.matrix);
        let least = least.max(share * values.into_iter().fold(0.0, f64::max));
        let mut step = Step { by: [0.0; 3], rank: 0, open: None };
        for (value, vector) in values.into_iter().zip(vectors) {
            if value > least {
                step.rank += 1;
                let along: f64 = (0..3).map(|i| vector[i] * self.pull[i]).sum::<f64>() / value;
                for (by, part) in step.by.iter_mut().zip(vector) {
                    *by += part * along;
                }
            } else {
                step.open = Some(vector);
            }
        }
        step
    }
}

/// Eigenvalues and unit eigenvectors of a symmetric matrix (Jacobi's rotations, without trigonometry).
fn eigen(mut m: [[f64; 3]; 3]) -> ([f64; 3], [[f64; 3]; 3]) {
    let mut vectors = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _ in 0..12 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if m[p][q].abs() <= 1e-15 * (m[p][p].abs() + m[q][q].abs()) {
                continue;
            }
            let theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
            let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
            let c = 1.0 / (t * t + 1.0).sqrt();
            let s = t * c;
            for row in &mut m {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
            turn_rows(&mut m, (p, q), (c, s));
            turn_rows(&mut vectors, (p, q), (c, s));
        }
    }
    ([m[0][0], m[1][1], m[2][2]], vectors)
}

/// Turns two rows into each other by the angle with that cosine and sine.
fn turn_rows(m: &mut [[f64; 3]; 3], (p, q): (usize, usize), (c, s): (f64, f64)) {
    let (first, second) = (m[p], m[q]);
    for (k, (a, b)) in first.into_iter().zip(second).enumerate() {
        m[p][k] = c * a - s * b;
        m[q][k] = s * a + c * b;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn eigenvectors_diagonalize(g in prop::collection::vec(prop::array::uniform3(-2.0f64..2.0), 1..8)) {
            let mut information = Information::default();
            for gradient in g {
                information.add(gradient, 0.0, 1.0);
            }
            let m = information.matrix;
            let (values, vectors) = eigen(m);
            for (value, vector) in values.into_iter().zip(vectors) {
                for row in 0..3 {
                    let image: f64 = (0..3).map(|k| m[row][k] * vector[k]).sum();
                    prop_assert!((image - value * vector[row]).abs() < 1e-9);
                }
            }
        }
    }

    #[test]
    fn a_direction_that_nothing_measures_gets_no_step() {
        let mut information = Information::default();
        information.add([1.0, 0.0, 0.0], 0.5, 1000.0);
        information.add([0.0, 0.0, 1.0], -0.1, 1000.0);
        let Step { by, rank, open } = information.step(100.0, 0.01);
        assert_eq!(rank, 2);
        assert!((by[0] + 0.5).abs() < 1e-12 && by[1].abs() < 1e-12 && (by[2] - 0.1).abs() < 1e-12);
        assert!(open.is_some_and(|open| open[1].abs() > 1.0 - 1e-12));
    }
}
