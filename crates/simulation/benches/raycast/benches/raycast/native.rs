use std::{hint::black_box, time::Instant};

use cogmap_raycast_bench::{Contest, POSES, SIZES};

use crate::{Outcome, Trial};

/// Times the trials in this process.
pub(crate) fn run(trials: &[Trial]) -> Vec<Outcome> {
    let mut contests = SIZES.map(Contest::new);
    let time = |trial: &Trial| {
        let contest = &mut contests[trial.size];
        let mut outcome = Outcome { segments: contest.segments(), micros: f64::INFINITY, sum: 0.0 };
        for _ in 0..trial.rounds {
            let start = Instant::now();
            outcome.sum = black_box(contest.run(black_box(trial.method), trial.scans));
            let micros = start.elapsed().as_secs_f64() * 1e6 / trial.scans as f64;
            outcome.micros = outcome.micros.min(micros);
        }
        outcome
    };
    trials.iter().map(time).collect()
}

/// Prints whether the raycaster and parry see the same.
pub(crate) fn print_differences() {
    for size in SIZES {
        let mut contest = Contest::new(size);
        let differ = contest.differences([0, 1], POSES);
        println!(
            "ours and parry over 1 mm apart, {} segments: {differ} of {} beams",
            contest.segments(),
            POSES * 361
        );
    }
}
