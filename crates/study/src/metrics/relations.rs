//! Mean translational error against relations that people matched by hand: how far the robot's own
//! belief of where it was at one moment, seen from another, lies from the truth.

use cogmap_formats::relations::Relation;
use cogmap_geometry::Pose;
use cogmap_mapping::{
    PathPoint,
    memory::{FrameId, Mfis},
};
use cogmap_simulation::Stamped;

/// A relation speaks of the row nearest in time, if that is no farther off than this, seconds.
const NEAR: f64 = 0.5;

/// How far a trajectory lies from relations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanError {
    /// Metres, over the relations compared.
    pub mean: f64,
    /// Relations compared.
    pub compared: usize,
    /// Relations of which a moment has no row, or no way joins the two.
    pub left_out: usize,
}

/// The error of a trajectory in one frame; `None` where no relation can be compared.
///
/// The rows should be dense: between scans a robot moves farther than a good mapper errs, see [`densify`].
#[must_use]
pub fn mean_error(relations: &[Relation], trajectory: &[Stamped]) -> Option<MeanError> {
    let pose_at = |t| Some(nearest(trajectory, t, |row| row.t)?.pose);
    error_of(relations, |relation| Some(pose_at(relation.from)?.from_here(pose_at(relation.to)?)))
}

/// The error of relations read from the network: the links composed along the shortest path between
/// the frames in which the two moments were lived through.
#[must_use]
pub fn network_error(relations: &[Relation], path: &[PathPoint], mfis: &Mfis) -> Option<MeanError> {
    let mut ways_from = (FrameId(0), mfis.ways_from(FrameId(0), f64::INFINITY));
    error_of(relations, |relation| {
        let at = |t| nearest(path, t, |point| point.t);
        let (from, to) = (at(relation.from)?, at(relation.to)?);
        if ways_from.0 != from.frame {
            ways_from = (from.frame, mfis.ways_from(from.frame, f64::INFINITY));
        }
        let way = ways_from.1.get(&to.frame)?;
        Some(from.frame_from_robot.from_here(way.here_from_frame * to.frame_from_robot))
    })
}

/// A path with a point for every record of odometry, which only carries on from the last view.
/// All lists are in the order of time.
#[must_use]
pub fn densify(path: &[PathPoint], odometry_at_views: &[Stamped], records: &[Stamped]) -> Vec<PathPoint> {
    let mut dense = Vec::with_capacity(path.len() + records.len());
    let mut records = records.iter().peekable();
    for (index, view) in path.iter().enumerate() {
        dense.push(*view);
        let last = odometry_at_views.partition_point(|row| row.t <= view.t).checked_sub(1);
        let Some(odom_from_view) = last.map(|last| odometry_at_views[last].pose) else { continue };
        let next = path.get(index + 1).map_or(f64::INFINITY, |next| next.t);
        while records.next_if(|record| record.t <= view.t).is_some() {}
        while let Some(record) = records.next_if(|record| record.t < next) {
            let frame_from_robot = view.frame_from_robot * odom_from_view.from_here(record.pose);
            dense.push(PathPoint { t: record.t, frame_from_robot, ..*view });
        }
    }
    dense
}

/// The path as it is drawn: in the map.
#[must_use]
pub fn in_map(path: &[PathPoint], mfis: &Mfis) -> Vec<Stamped> {
    path.iter().map(|point| Stamped { t: point.t, pose: mfis.place_of(point) }).collect()
}

#[allow(clippy::cast_precision_loss, reason = "nobody matches 2^53 relations by hand")]
fn error_of(
    relations: &[Relation],
    mut believed: impl FnMut(&Relation) -> Option<Pose>,
) -> Option<MeanError> {
    let apart =
        |relation: &Relation| Some(believed(relation)?.position.distance(relation.from_from_to.position));
    let errors: Vec<f64> = relations.iter().filter_map(apart).collect();
    let (compared, left_out) = (errors.len(), relations.len() - errors.len());
    (compared > 0).then(|| MeanError {
        mean: errors.iter().sum::<f64>() / compared as f64,
        compared,
        left_out,
    })
}

/// The row nearest in time.
fn nearest<Row>(rows: &[Row], t: f64, time: impl Fn(&Row) -> f64) -> Option<&Row> {
    let after = rows.partition_point(|row| time(row) < t);
    let candidates = [after.checked_sub(1), Some(after)].into_iter().flatten();
    candidates
        .filter_map(|index| rows.get(index))
        .min_by(|a, b| (time(a) - t).abs().total_cmp(&(time(b) - t).abs()))
        .filter(|row| (time(row) - t).abs() <= NEAR)
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::trig::FRAC_PI_2;
    use cogmap_mapping::{Mapper, MapperSetup};

    use super::*;

    fn at(t: f64, x: f64, y: f64, heading: f64) -> Stamped {
        Stamped { t, pose: Pose::new(x, y, heading) }
    }

    fn relation(from: f64, to: f64, x: f64, y: f64) -> Relation {
        Relation { from, to, from_from_to: Pose::new(x, y, 0.0) }
    }

    #[test]
    fn the_error_is_the_mean_distance_in_the_frame_of_the_first_moment() {
        // At 1 s the robot looks along y: what lies at (0, 3) in the map is 2 m ahead of it.
        let trajectory = [at(1.0, 0.0, 1.0, FRAC_PI_2), at(2.0, 0.0, 3.0, 0.0), at(3.0, 4.0, 3.0, 0.0)];
        let relations = [
            relation(1.0, 2.0, 2.0, 0.3), // 0.3 m off to the side
            relation(2.0, 3.1, 4.1, 0.0), // 0.1 m off ahead
            relation(2.0, 9.0, 0.0, 0.0), // nobody knows
        ];
        let error = mean_error(&relations, &trajectory).unwrap();
        assert!((error.mean - 0.2).abs() < 1e-12);
        assert_eq!((error.compared, error.left_out), (2, 1));
        assert_eq!(mean_error(&relations[2..], &trajectory), None);
    }

    #[test]
    fn between_views_odometry_carries_on_from_the_last_one() {
        let point = |step: usize, t, x| PathPoint {
            step,
            t,
            frame: FrameId(0),
            frame_from_robot: Pose::new(x, 0.0, FRAC_PI_2),
        };
        let odometry = [at(0.0, 0.0, 0.0, 0.0), at(2.0, 1.0, 0.0, 0.0)];
        let records = [at(0.0, 0.0, 0.0, 0.0), at(1.0, 0.4, 0.0, 0.0), at(3.0, 1.5, 0.0, 0.0)];
        let dense = densify(&[point(0, 0.0, 0.0), point(1, 2.0, 7.0)], &odometry, &records);
        let rows: Vec<_> = dense.iter().map(|p| (p.t, p.frame_from_robot.position)).collect();
        let expected = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.4), (2.0, 7.0, 0.0), (3.0, 7.0, 0.5)];
        assert_eq!(rows.len(), expected.len());
        for ((t, position), (t_wanted, x, y)) in rows.into_iter().zip(expected) {
            assert!(t == t_wanted && position.distance((x, y).into()) < 1e-12);
        }
    }

    #[test]
    fn in_one_frame_network_and_trajectory_say_the_same() {
        let mapper = Mapper::new(&MapperSetup::named("perceptual").unwrap(), 1);
        let path: Vec<PathPoint> = (0..5)
            .map(|step| PathPoint {
                step,
                t: step as f64,
                frame: FrameId(0),
                frame_from_robot: Pose::new(step as f64, 0.1 * (step * step) as f64, 0.3 * step as f64),
            })
            .collect();
        let relations = [relation(0.0, 3.0, 2.0, 1.0), relation(4.0, 1.0, -1.0, 0.5)];
        let mfis = mapper.mfis();
        assert_eq!(network_error(&relations, &path, mfis), mean_error(&relations, &in_map(&path, mfis)));
    }
}
