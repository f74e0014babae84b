use std::fmt::Write;

use cogmap_geometry::Pose;
use cogmap_simulation::{Session, Stamped};

use super::{labels, trajectory};

/// The way of a run as a table for spreadsheets (CSV, RFC 4180): a row a scan, seconds, metres and radians.
/// After the time stand x, y and heading of the truth (where there is one), of odometry and of each
/// mapper's belief, each in its own frame, as in the `.tum` files.
#[must_use]
pub fn table(session: &Session) -> String {
    let mut columns: Vec<(String, Vec<Stamped>)> = Vec::new();
    if session.world_from_robot().is_some() {
        columns.push(("truth".to_owned(), trajectory::truth(session)));
    }
    columns.push(("odometry".to_owned(), trajectory::odometry(session, None)));
    for (index, label) in labels(session.record()).into_iter().enumerate() {
        let name = if label.is_empty() { "estimate".to_owned() } else { format!("estimate-{label}") };
        columns.push((name, trajectory::estimate(session, index, None)));
    }
    written(&columns)
}

fn written(columns: &[(String, Vec<Stamped>)]) -> String {
    let mut text = String::from("t");
    for (name, _) in columns {
        // Writing to a string cannot fail.
        let _ = write!(text, ",{name} x,{name} y,{name} heading");
    }
    text.push_str("\r\n");
    let rows = columns.iter().map(|(_, poses)| poses.len()).max().unwrap_or(0);
    for row in 0..rows {
        let at = |(_, poses): &(String, Vec<Stamped>)| poses.get(row).copied();
        let t = columns.iter().find_map(at).map_or(0.0, |stamped| stamped.t);
        let _ = write!(text, "{t}");
        for column in columns {
            text.push_str(&at(column).map_or(",,,".to_owned(), |Stamped { pose, .. }| cells(pose)));
        }
        text.push_str("\r\n");
    }
    text
}

fn cells(Pose { position, heading }: Pose) -> String {
    // Adding zero makes a negative zero positive.
    let [x, y, heading] = [position.x, position.y, heading].map(|number| number + 0.0);
    format!(",{x},{y},{heading}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_has_a_cell_for_each_column() {
        let at = |t: f64| Stamped { t, pose: Pose::new(t, -0.0, 0.5) };
        let columns = [("truth".to_owned(), vec![at(0.0), at(1.5)]), ("odometry".to_owned(), vec![at(0.0)])];
        let text = written(&columns);
        let rows: Vec<&str> = text.split("\r\n").collect();
        assert_eq!(rows[0], "t,truth x,truth y,truth heading,odometry x,odometry y,odometry heading");
        assert_eq!(rows[2], "1.5,1.5,0,0.5,,,");
        assert!(rows.iter().take(3).all(|row| row.matches(',').count() == 6) && rows[3].is_empty());
    }
}
