use super::{Values, count};
use crate::{Drive, Mapping};

/// The robot should notice within so many scans that it was moved.
const SOON: usize = 3;

/// Whether a robot that was moved unseen noticed it, and what it mapped until then.
pub(super) fn score(drive: &Drive, mapping: &Mapping, values: &mut Values) {
    let Some(moved) = drive.kidnapped else { return };
    let after = || mapping.reports.iter().zip(&mapping.look_of_report).filter(|(_, look)| **look >= moved);
    let noticed = after().position(|(report, _)| report.lost.is_some());
    let scans = noticed.and_then(|view| after().nth(view)).map(|(_, look)| look + 1 - moved);
    values.put("noticed_after", scans.map(count));
    values.put("noticed", f64::from(u8::from(scans.is_some_and(|scans| scans <= SOON))));
    let mut until = after().take(noticed.unwrap_or(usize::MAX));
    values.put("mapped_silently", f64::from(u8::from(until.any(|(report, _)| !report.placed.is_empty()))));
    let mut since = after().skip(noticed.unwrap_or(usize::MAX));
    values.put("found_again", f64::from(u8::from(since.any(|(report, _)| report.recalled.is_some()))));
}
