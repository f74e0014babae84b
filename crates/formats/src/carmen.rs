//! Logs of the CARMEN toolkit: how most recorded drives of real robots were published.

mod fields;
mod lasers;
mod message;

use std::collections::BTreeMap;

use cogmap_mapping::perception::Reading;
use cogmap_simulation::{Recording, Stamped};
use serde::Serialize;

use crate::{FormatError, error::Place, gzip};
use lasers::{Laser, LaserNotes};
use message::{Message, RawScan, Side};

/// The most readings of the laser that one log may hold.
const READING_LIMIT: usize = 30_000_000;
/// The longest line that is looked at, bytes.
const LINE_LIMIT: usize = 1 << 20;
/// How many broken lines are told one by one; the rest are counted.
const TOLD: usize = 100;
/// How many different unknown keywords are told apart.
const KEYWORDS: usize = 64;

/// A log as it was understood, and what was not.
#[derive(Clone, Debug, PartialEq)]
pub struct CarmenLog {
    /// The scans and the odometry, in the order of the file.
    pub recording: Recording,
    /// What the file's lines were.
    pub counts: Counts,
    /// The first hundred broken lines.
    pub skipped: Vec<SkippedLine>,
    /// What the reader had to guess, each a sentence.
    pub warnings: Vec<String>,
}

/// What the lines of a log were.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// All lines.
    pub lines: usize,
    /// Scans taken.
    pub scans: usize,
    /// Odometry records taken.
    pub odometry: usize,
    /// `PARAM` lines.
    pub params: usize,
    /// Lines that begin with `#`.
    pub comments: usize,
    /// Lines of other keywords, by keyword.
    pub unknown: BTreeMap<String, usize>,
    /// Lines that do not follow the format; they were skipped.
    pub broken: usize,
    /// Scans that repeat the one before under another keyword; they were skipped.
    pub duplicates: usize,
    /// Scans stamped no later than the one before; the order of the file was kept.
    pub not_later: usize,
}

/// A line that was left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SkippedLine {
    /// From 1.
    pub line: usize,
    /// What is wrong with it.
    pub reason: String,
}

/// Reads a CARMEN log, packed with gzip or not. Broken lines are counted and skipped, or with
/// `strict` are errors; a log without a usable scan is an error.
///
/// ```
/// let log = b"ODOM 0 0 0 0 0 0 1.5 robot 0\nFLASER 3 2.0 1.0 2.0 0.1 0 0 0 0 0 2.0 robot 0.5\n";
/// let log = cogmap_formats::carmen::read(log, "tiny.log", true)?;
/// assert_eq!((log.counts.scans, log.counts.odometry), (1, 1));
/// assert_eq!(log.recording.readings[0].scan.robot_from_laser.position.x, 0.1);
/// # Ok::<(), cogmap_formats::FormatError>(())
/// ```
///
/// # Errors
/// [`FormatError`] with the line where `strict` stopped, or with what there was instead of scans.
pub fn read(bytes: &[u8], file: &str, strict: bool) -> Result<CarmenLog, FormatError> {
    let bytes = gzip::unpack(bytes, file)?;
    let mut reader = Reader { file, strict, ..Reader::default() };
    let text = bytes.strip_suffix(b"\n").unwrap_or(&bytes);
    for (index, line) in text.split(|&byte| byte == b'\n').enumerate() {
        reader.counts.lines = index + 1;
        reader.line(index + 1, line)?;
    }
    reader.finish()
}

/// What has been read so far.
#[derive(Default)]
struct Reader<'a> {
    file: &'a str,
    strict: bool,
    scans: Vec<RawScan>,
    readings: usize,
    odometry: Vec<Stamped>,
    front: LaserNotes,
    rear: LaserNotes,
    counts: Counts,
    skipped: Vec<SkippedLine>,
}

impl Reader<'_> {
    fn line(&mut self, number: usize, line: &[u8]) -> Result<(), FormatError> {
        let understood = if line.len() > LINE_LIMIT {
            Err(format!("the line is longer than {LINE_LIMIT} bytes"))
        } else {
            message::parse(line)
        };
        match understood {
            Ok(message) => self.take(message),
            Err(reason) => self.skip(number, reason),
        }
    }

    fn take(&mut self, message: Message) -> Result<(), FormatError> {
        match message {
            Message::Blank => {}
            Message::Comment => self.counts.comments += 1,
            Message::Param(name, value) => {
                self.counts.params += 1;
                self.front.note("front", &name, &value);
                self.rear.note("rear", &name, &value);
            }
            Message::Odometry(record) => self.odometry.push(record),
            Message::Scan(scan) => return self.scan(scan),
            Message::Unknown(keyword) => {
                let many =
                    self.counts.unknown.len() >= KEYWORDS && !self.counts.unknown.contains_key(&keyword);
                let keyword = if many { "(others)".to_owned() } else { keyword };
                *self.counts.unknown.entry(keyword).or_default() += 1;
            }
        }
        Ok(())
    }

    fn scan(&mut self, scan: RawScan) -> Result<(), FormatError> {
        if let Some(last) = self.scans.last() {
            if last.t == scan.t && last.ranges == scan.ranges {
                self.counts.duplicates += 1;
                return Ok(());
            }
            self.counts.not_later += usize::from(scan.t <= last.t && scan.side == last.side);
        }
        self.readings += scan.ranges.len();
        self.scans.push(scan);
        if self.readings > READING_LIMIT {
            let place = Place::file(self.file);
            return Err(FormatError::TooLarge { place, limit: READING_LIMIT, unit: "readings of the laser" });
        }
        Ok(())
    }

    fn skip(&mut self, number: usize, reason: String) -> Result<(), FormatError> {
        if self.strict {
            let remedy = "correct or remove the line, or read without `--strict` to skip it";
            return Err(FormatError::Line { place: Place::line(self.file, number), problem: reason, remedy });
        }
        self.counts.broken += 1;
        if self.skipped.len() < TOLD {
            self.skipped.push(SkippedLine { line: number, reason });
        }
        Ok(())
    }

    fn finish(mut self) -> Result<CarmenLog, FormatError> {
        if !self.scans.iter().any(RawScan::shows_something) {
            return Err(FormatError::NoScan { place: Place::file(self.file), seen: self.seen() });
        }
        self.counts.scans = self.scans.len();
        self.counts.odometry = self.odometry.len();
        let (readings, warnings) = self.readings();
        let recording = Recording { readings, odometry: self.odometry };
        Ok(CarmenLog { recording, counts: self.counts, skipped: self.skipped, warnings })
    }

    fn readings(&mut self) -> (Vec<Reading>, Vec<String>) {
        let scans = std::mem::take(&mut self.scans);
        let (front, front_warning) = Laser::of(&scans, Side::Front, self.front);
        let (rear, rear_warning) = Laser::of(&scans, Side::Rear, self.rear);
        let laser = |side| if side == Side::Front { front } else { rear };
        let readings = scans.into_iter().map(|scan| laser(scan.side).reading(scan)).collect();
        (readings, front_warning.into_iter().chain(rear_warning).collect())
    }

    /// What a log without scans held, for its error.
    fn seen(&self) -> String {
        let mut seen = vec![format!("{} odometry records", self.odometry.len())];
        if !self.scans.is_empty() {
            seen.push(format!("{} scans without a single distance", self.scans.len()));
        }
        seen.push(format!("{} broken lines", self.counts.broken));
        if let Some(first) = self.skipped.first() {
            seen.push(format!("the first, line {}: {}", first.line, first.reason));
        }
        let unknown: usize = self.counts.unknown.values().sum();
        if let Some(keyword) = self.counts.unknown.keys().next() {
            seen.push(format!("{unknown} unknown lines such as `{keyword}`"));
        }
        seen.join(", ")
    }
}
