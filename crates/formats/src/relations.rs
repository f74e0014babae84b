//! Relations between the poses of a drive, matched by hand: the ground truth of the SLAM benchmark
//! of Kümmerle et al. (2009). A row a relation, `t1 t2 x y z roll pitch yaw`, seconds, metres and
//! radians.

use cogmap_geometry::Pose;

use crate::{FormatError, error::Place};

/// Where the robot truly was at one moment, seen from where it was at another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relation {
    /// The moment that it is seen from, seconds.
    pub from: f64,
    /// The moment of the pose, seconds.
    pub to: f64,
    /// The pose, of which only what lies in the plane is kept.
    pub from_from_to: Pose,
}

/// Reads relations; empty lines and lines that begin with `#` are passed over.
///
/// ```
/// let relations = cogmap_formats::relations::read("10 12 0.5 -0.1 0 0 0 1.5\n", "a.relations")?;
/// assert_eq!((relations[0].from, relations[0].from_from_to.position.x), (10.0, 0.5));
/// # Ok::<(), cogmap_formats::FormatError>(())
/// ```
///
/// # Errors
/// [`FormatError::Line`] with the first line that is no relation.
pub fn read(text: &str, file: &str) -> Result<Vec<Relation>, FormatError> {
    let lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
    let rows = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    rows.map(|(number, line)| {
        row(line).map_err(|problem| FormatError::Line {
            place: Place::line(file, number),
            problem,
            remedy: "write `t1 t2 x y z roll pitch yaw`, eight numbers apart by spaces",
        })
    })
    .collect()
}

fn row(line: &str) -> Result<Relation, String> {
    let number = |word: &str| {
        let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
        number
            .ok_or_else(|| format!("`{}` is not a finite number", word.chars().take(32).collect::<String>()))
    };
    let numbers = line.split_whitespace().take(9).map(number).collect::<Result<Vec<_>, _>>()?;
    let Ok([from, to, x, y, _, _, _, yaw]) = <[f64; 8]>::try_from(numbers) else {
        return Err(format!("{} words, where a relation has 8", line.split_whitespace().count()));
    };
    Ok(Relation { from, to, from_from_to: Pose::new(x, y, yaw) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn no_text_breaks_the_reader(text in "[-0-9a-zN #.\n\t]{0,200}") {
            let _ = read(&text, "a.relations");
        }
    }

    #[test]
    fn a_bad_row_is_named_by_its_line() {
        let error = read("# t1 t2\n\n1 2 3 0 0 0 0 1\n1 2\n", "a.relations").unwrap_err().to_string();
        assert!(error.starts_with("a.relations, line 4: 2 words"), "{error}");
        assert!(read("1 2 inf 0 0 0 0 1", "a").unwrap_err().to_string().contains("`inf`"));
    }
}
