use std::{fs, hint::black_box, path::Path, time::Instant};

use cogmap_steps_bench::Prepared;

use crate::{Outcome, ROUNDS};

/// Times the tasks in this process.
pub(crate) fn run(tasks: &[usize], log: Option<&Path>) -> Vec<Outcome> {
    let log = log.and_then(|log| fs::read(log).ok()).unwrap_or_default();
    tasks.iter().filter_map(|&task| Some(time(&Prepared::new(task, &log)?))).collect()
}

fn time(prepared: &Prepared) -> Outcome {
    let (steps, mut micros, mut sum) = (prepared.steps(), f64::INFINITY, 0.0);
    for _ in 0..ROUNDS {
        let mapper = prepared.start();
        let start = Instant::now();
        sum = black_box(prepared.run(black_box(mapper)));
        micros = micros.min(start.elapsed().as_secs_f64() * 1e6 / steps.max(1) as f64);
    }
    Outcome { steps, micros, sum }
}
