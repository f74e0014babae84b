use cogmap_geometry::Pose;
use cogmap_simulation::{Session, Stamped};

/// Where the robot was, a row a scan, and where it stopped.
pub(super) fn truth(session: &Session) -> Vec<Stamped> {
    let mut rows = session.journal().truth.clone();
    rows.extend(stop(session, &rows).zip(session.world_from_robot()).map(|(t, pose)| Stamped { t, pose }));
    rows
}

/// Where odometry believed it was.
pub(super) fn odometry(session: &Session, dense: Option<&[Stamped]>) -> Vec<Stamped> {
    let scans = &session.journal().odometry;
    let mut rows = between(scans, dense.unwrap_or_default(), |_, record| Some(record.pose));
    rows.extend(stop(session, &rows).map(|t| Stamped { t, pose: session.odom_from_robot() }));
    rows
}

/// Where a mapper believed it was; between scans odometry goes on from there.
pub(super) fn estimate(session: &Session, index: usize, dense: Option<&[Stamped]>) -> Vec<Stamped> {
    let (journal, mapper) = (session.journal(), session.mappers().get(index));
    let Some(estimate) = journal.mappers.get(index).map(|mapper| &mapper.estimate) else {
        return Vec::new();
    };
    let mut rows = between(estimate, dense.unwrap_or_default(), |scan, record| {
        let (map_from_scan, odom_from_scan) = (estimate.get(scan)?.pose, journal.odometry.get(scan)?.pose);
        Some(map_from_scan * odom_from_scan.from_here(record.pose))
    });
    let last = mapper.and_then(|mapper| mapper.map_from_robot(session.odom_from_robot()));
    rows.extend(stop(session, &rows).zip(last).map(|(t, pose)| Stamped { t, pose }));
    rows
}

/// The time at which a simulated robot stopped, if that was after the last row.
fn stop(session: &Session, rows: &[Stamped]) -> Option<f64> {
    session.world_from_robot()?;
    let t = session.time();
    rows.last().is_none_or(|last| last.t < t).then_some(t)
}

/// The rows of the scans, and among them a row for each record that lies between two scans.
fn between(
    scans: &[Stamped],
    records: &[Stamped],
    pose_of: impl Fn(usize, &Stamped) -> Option<Pose>,
) -> Vec<Stamped> {
    let mut rows = Vec::with_capacity(scans.len() + records.len());
    let mut records = records.iter().peekable();
    for (index, scan) in scans.iter().enumerate() {
        rows.push(*scan);
        // Before the first scan there is nothing to go on from; at a scan there is the scan.
        while records.next_if(|record| record.t <= scan.t).is_some() {}
        let next = scans.get(index + 1).map_or(f64::INFINITY, |next| next.t);
        while let Some(record) = records.next_if(|record| record.t < next) {
            rows.extend(pose_of(index, record).map(|pose| Stamped { t: record.t, pose }));
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(t: f64, x: f64) -> Stamped {
        Stamped { t, pose: Pose::new(x, 0.0, 0.0) }
    }

    #[test]
    fn records_go_between_the_scans_in_order() {
        let scans = [at(1.0, 0.0), at(2.0, 1.0)];
        let records = [at(0.5, 9.0), at(1.0, 9.0), at(1.2, 0.2), at(2.0, 9.0), at(2.5, 1.5)];
        let rows = between(&scans, &records, |_, record| Some(record.pose));
        assert_eq!(rows, [at(1.0, 0.0), at(1.2, 0.2), at(2.0, 1.0), at(2.5, 1.5)]);
    }
}
