use std::{hint::black_box, time::Instant};

use cogmap_raycast_bench::{BATCH, Contest, POSES, SIZES};

use crate::{Outcome, Trial};

/// Times the trials in this process.
pub(crate) fn run(trials: &[Trial]) -> Vec<Outcome> {
    let mut contests = SIZES.map(Contest::new);
    let time = |trial: &Trial| {
        let contest = &mut contests[trial.size];
        let mut best = vec![(f64::INFINITY, 0.0); trial.batches];
        for _ in 0..trial.rounds {
            for (batch, (micros, sum)) in best.iter_mut().enumerate() {
                let start = Instant::now();
                *sum = black_box(contest.run(black_box(trial.method), batch * BATCH));
                *micros = micros.min(start.elapsed().as_secs_f64() * 1e6);
            }
        }
        let micros = best.iter().map(|(micros, _)| micros).sum::<f64>() / (trial.batches * BATCH) as f64;
        Outcome { segments: contest.segments(), micros, sum: best.iter().map(|(_, sum)| sum).sum() }
    };
    trials.iter().map(time).collect()
}

/// Prints whether the raycaster and parry see the same.
pub(crate) fn print_differences() {
    for size in SIZES {
        let mut contest = Contest::new(size);
        let differ = contest.differences([0, 1]);
        println!(
            "ours and parry over 1 mm apart, {} segments: {differ} of {} beams",
            contest.segments(),
            POSES * 361
        );
    }
}
