use std::path::Path;

use cogmap_formats::run::labels;
use cogmap_geometry::Pose;
use cogmap_mapping::{Event, Mapper, MapperSetup, Placement};
use cogmap_simulation::{MapperJournal, Session, Source, Stamped};

use crate::table::Table;

/// What came out of a run, for people who have never seen one.
pub(crate) fn of(title: &str, session: &Session, seconds: f64) -> String {
    let mut table = Table::new(&heads(session));
    for (index, label) in labels(session.record()).iter().enumerate() {
        table.row(cells(session, index, label));
    }
    format!("{title}\n  {}\n\n{}\n{}", figures(session, seconds), table.render(), legend(session))
}

/// What was left where.
pub(crate) fn of_files(directory: &Path, files: &[(String, Vec<u8>)]) -> String {
    let place = directory.display();
    let pictures: Vec<&str> =
        files.iter().map(|(name, _)| name.as_str()).filter(|name| name.ends_with(".png")).collect();
    let are = if pictures.len() == 1 { "picture is" } else { "pictures are" };
    format!(
        "\n{} files in {place}/; the {are} {}\nAgain: cogmap replay {}\n",
        files.len() + 1,
        pictures.join(" and "),
        directory.join("session.json").display()
    )
}

/// The run itself in one line.
fn figures(session: &Session, seconds: f64) -> String {
    let journal = session.journal();
    let scans = journal.odometry.len();
    let duration = journal.odometry.first().zip(journal.odometry.last()).map_or(0.0, |(a, b)| b.t - a.t);
    let clock = format!("{scans} scans in {}, done in {seconds:.2} s", span(duration));
    match &session.record().source {
        Source::World { commands, .. } => {
            let collisions = match journal.mappers.first().map_or(0, |mapper| mapper.collisions().count()) {
                0 => String::new(),
                1 => ", 1 collision".into(),
                many => format!(", {many} collisions"),
            };
            let way = length(&journal.truth);
            format!(
                "{} commands, {way:.1} m{collisions}, seed {}; {clock}",
                commands.len(),
                session.record().seed
            )
        }
        Source::Log { .. } => format!("{:.1} m by its odometry; {clock}", length(&journal.odometry)),
    }
}

fn span(seconds: f64) -> String {
    if seconds < 120.0 { format!("{seconds:.0} s") } else { format!("{:.0} min", seconds / 60.0) }
}

fn heads(session: &Session) -> Vec<&'static str> {
    let mut heads =
        vec!["mapper", "views", "surfaces", "weak", "fallbacks", "ASRs", "exits", "loops", "path"];
    if session.world_from_robot().is_some() {
        heads.push("off by");
    }
    heads
}

fn cells(session: &Session, index: usize, label: &str) -> Vec<String> {
    let (journal, record) = (session.journal(), session.record());
    let (Some(setup), Some(mapper), Some(written)) =
        (record.mappers.get(index), session.mappers().get(index), journal.mappers.get(index))
    else {
        return Vec::new();
    };
    let placed = |by: Placement| written.reports.iter().filter(|report| report.placement == by).count();
    let [weak, fallbacks] = match setup {
        MapperSetup::Odometry(_) => ["–".to_owned(), "–".to_owned()],
        _ => [Placement::WeakReference, Placement::Odometry].map(|by| placed(by).to_string()),
    };
    let [asrs, exits, loops] = places(mapper, written);
    let mut cells = vec![
        if label.is_empty() { setup.name() } else { label }.to_owned(),
        written.reports.len().to_string(),
        mapper.mfis().remembered().count().to_string(),
        weak,
        fallbacks,
        asrs,
        exits,
        loops,
        format!("{:.1} m", length(&written.estimate)),
    ];
    if let Some((metres, radians)) = error_at_end(&journal.truth, &written.estimate) {
        cells.push(format!("{metres:.2} m, {:.1}°", radians.to_degrees()));
    }
    cells
}

/// Local spaces, exits and closed loops; dashes for a mapper that does not know what a space is.
fn places(mapper: &Mapper, written: &MapperJournal) -> [String; 3] {
    let Some(network) = mapper.network() else { return ["–", "–", "–"].map(str::to_owned) };
    let loops = written.map_events().filter(|(_, event)| matches!(event, Event::LoopClosed { .. }));
    [network.asrs().len(), network.exits().len(), loops.count()].map(|count| count.to_string())
}

fn legend(session: &Session) -> String {
    let mut legend = String::from(
        "  views      scans that the mapper took into its map (the others it lets pass)
  surfaces   pieces of wall and furniture in its map
  weak       views placed by a surface whose place along its own line was a guess
  fallbacks  views in which nothing known was recognised, placed by odometry
  ASRs       local spaces that it shares its map out among (– where a mapper does not)
  exits      narrow places between them that the robot went through
  loops      times that it found itself back in a space that it knew
  path       length of the way as the mapper has it\n",
    );
    if session.world_from_robot().is_some() {
        legend +=
            "  off by     how far from where it believes to be the robot stands at the end, and how turned\n";
    }
    legend
}

/// Metres along a trajectory.
fn length(track: &[Stamped]) -> f64 {
    track.windows(2).map(|pair| pair[0].pose.position.distance(pair[1].pose.position)).sum()
}

/// How far off an estimate is at its end, once both begin at the same place: metres, radians.
fn error_at_end(truth: &[Stamped], estimate: &[Stamped]) -> Option<(f64, f64)> {
    let moved =
        |track: &[Stamped]| -> Option<Pose> { Some(track.first()?.pose.from_here(track.last()?.pose)) };
    let off = moved(truth)?.from_here(moved(estimate)?);
    Some((off.position.length(), off.heading.abs()))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    fn track(poses: &[(f64, f64, f64)]) -> Vec<Stamped> {
        poses.iter().map(|&(x, y, heading)| Stamped { t: 0.0, pose: Pose::new(x, y, heading) }).collect()
    }

    #[test]
    fn the_error_does_not_care_in_which_frame_the_estimate_begins() {
        let truth = track(&[(1.0, 1.0, 0.0), (4.0, 1.0, 0.0)]);
        let estimate = track(&[(0.0, 0.0, FRAC_PI_2), (0.0, 2.5, 1.7)]);
        let (metres, radians) = error_at_end(&truth, &estimate).unwrap();
        assert!((metres - 0.5).abs() < 1e-12 && (radians - (1.7 - FRAC_PI_2)).abs() < 1e-12);
        assert_eq!(error_at_end(&[], &estimate), None);
    }

    #[test]
    fn length_adds_up_the_pieces() {
        assert!((length(&track(&[(0.0, 0.0, 0.0), (3.0, 4.0, 0.0), (3.0, 5.0, 1.0)])) - 6.0).abs() < 1e-12);
    }
}
