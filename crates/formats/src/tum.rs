//! Trajectories as the benchmark tools of the TU Munich read them: a row a pose,
//! `t x y z qx qy qz qw`, seconds and metres.

use std::fmt::Write;

use cogmap_geometry::{Pose, trig};
use cogmap_simulation::Stamped;

use crate::{FormatError, error::Place};

/// The trajectory as text, every number as short as it can be read back.
///
/// ```
/// use cogmap_geometry::Pose;
/// use cogmap_simulation::Stamped;
/// let rows = cogmap_formats::tum::write(&[Stamped { t: 1.5, pose: Pose::new(2.0, -0.5, 0.0) }]);
/// assert_eq!(rows, "1.5 2 -0.5 0 0 0 0 1\n");
/// ```
#[must_use]
pub fn write(poses: &[Stamped]) -> String {
    let mut text = String::new();
    for Stamped { t, pose } in poses {
        let (sin, cos) = trig::sin_cos(pose.heading / 2.0);
        // Adding zero makes a negative zero positive.
        let [t, x, y, sin, cos] = [*t, pose.position.x, pose.position.y, sin, cos].map(|number| number + 0.0);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{t} {x} {y} 0 0 0 {sin} {cos}");
    }
    text
}

/// Reads a trajectory; of each pose what lies in the plane. Empty lines and lines that begin with
/// `#` are passed over.
///
/// # Errors
/// [`FormatError::Line`] with the first line that is no pose.
pub fn read(text: &str, file: &str) -> Result<Vec<Stamped>, FormatError> {
    let lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
    let rows = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    rows.map(|(number, line)| {
        row(line).map_err(|problem| FormatError::Line {
            place: Place::line(file, number),
            problem,
            remedy: "write `t x y z qx qy qz qw`, eight numbers apart by spaces",
        })
    })
    .collect()
}

fn row(line: &str) -> Result<Stamped, String> {
    let number = |word: &str| {
        let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
        number
            .ok_or_else(|| format!("`{}` is not a finite number", word.chars().take(32).collect::<String>()))
    };
    let numbers = line.split_whitespace().take(9).map(number).collect::<Result<Vec<_>, _>>()?;
    let Ok([t, x, y, _, qx, qy, qz, qw]) = <[f64; 8]>::try_from(numbers) else {
        return Err(format!("{} words, where a pose has 8", line.split_whitespace().count()));
    };
    let norm = qx * qx + qy * qy + qz * qz + qw * qw;
    if !(0.5..2.0).contains(&norm) {
        return Err(format!("the quaternion's square is {norm}, where 1 should be"));
    }
    let heading = trig::atan2(2.0 * (qw * qz + qx * qy), norm - 2.0 * (qy * qy + qz * qz));
    Ok(Stamped { t, pose: Pose::new(x, y, heading) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_trajectory_survives_its_file(
            rows in prop::collection::vec((0.0f64..2e9, -1e3f64..1e3, -1e3f64..1e3, -3.1f64..3.1), 0..20),
        ) {
            let poses: Vec<Stamped> =
                rows.iter().map(|&(t, x, y, h)| Stamped { t, pose: Pose::new(x, y, h) }).collect();
            let again = read(&write(&poses), "a.tum").unwrap();
            prop_assert_eq!(again.len(), poses.len());
            for (was, is) in poses.iter().zip(&again) {
                prop_assert_eq!((was.t, was.pose.position), (is.t, is.pose.position));
                prop_assert!((was.pose.heading - is.pose.heading).abs() < 1e-12);
            }
        }

        #[test]
        fn no_text_breaks_the_reader(text in "[-0-9a-zN #.\n\t]{0,200}") {
            let _ = read(&text, "a.tum");
        }
    }

    #[test]
    fn a_bad_row_is_named_by_its_line() {
        let error = read("# t x y\n1 2 3 0 0 0 0 1\n1 2\n", "a.tum").unwrap_err().to_string();
        assert!(error.starts_with("a.tum, line 3: 2 words"), "{error}");
        assert!(read("1 2 3 0 0 0 0 0", "a.tum").unwrap_err().to_string().contains("quaternion"));
        assert!(read("1 2 nan 0 0 0 0 1", "a.tum").unwrap_err().to_string().contains("`nan`"));
    }
}
