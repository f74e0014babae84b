use std::time::Instant;

use serde::Serialize;

/// How long each stage of a command took on this machine's clock. It goes into a file of its own,
/// because all others are the same at every run.
#[derive(Debug)]
pub(crate) struct Timing {
    stage_began: Instant,
    stages: Vec<Stage>,
}

#[derive(Debug, Serialize)]
struct Stage {
    stage: &'static str,
    seconds: f64,
}

#[derive(Serialize)]
struct TimingFile<'a> {
    format: &'static str,
    stages: &'a [Stage],
    total_seconds: f64,
}

impl Timing {
    /// The first stage begins.
    pub(crate) fn start() -> Self {
        Self { stage_began: Instant::now(), stages: Vec::new() }
    }

    /// The stage that was under way is over and had this name; the next begins.
    pub(crate) fn done(&mut self, stage: &'static str) {
        let now = Instant::now();
        let seconds = now.duration_since(self.stage_began).as_secs_f64();
        self.stages.push(Stage { stage, seconds });
        self.stage_began = now;
    }

    /// Seconds of all stages so far.
    pub(crate) fn total(&self) -> f64 {
        self.stages.iter().map(|stage| stage.seconds).sum()
    }

    /// The content of `timing.json`.
    pub(crate) fn to_json(&self) -> String {
        let file =
            TimingFile { format: "cogmap-timing/1", stages: &self.stages, total_seconds: self.total() };
        serde_json::to_string_pretty(&file).unwrap_or_default() + "\n"
    }

    /// The same with something else that a clock measured.
    pub(crate) fn to_json_with(&self, name: &str, more: &impl Serialize) -> String {
        let mut file: serde_json::Value = serde_json::from_str(&self.to_json()).unwrap_or_default();
        file[name] = serde_json::to_value(more).unwrap_or_default();
        serde_json::to_string_pretty(&file).unwrap_or_default() + "\n"
    }
}
