use std::io::IsTerminal;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A bar for work of known length; nothing is drawn where standard error is no terminal.
pub(crate) fn bar(length: u64, unit: &'static str) -> ProgressBar {
    let template = format!("  {{wide_bar}} {{pos}} of {{len}} {unit}, {{elapsed}} (still {{eta}})");
    let bar = ProgressBar::with_draw_target(Some(length), target());
    styled(bar, &template)
}

/// A sign of life for work of unknown length, with a message beside it.
pub(crate) fn spinner() -> ProgressBar {
    styled(ProgressBar::with_draw_target(None, target()), "  {spinner} {msg}")
}

fn styled(bar: ProgressBar, template: &str) -> ProgressBar {
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

fn target() -> ProgressDrawTarget {
    if std::io::stderr().is_terminal() {
        ProgressDrawTarget::stderr_with_hz(10)
    } else {
        ProgressDrawTarget::hidden()
    }
}

/// How often a message is worth changing.
pub(crate) const MESSAGE_EVERY: Duration = Duration::from_millis(100);
