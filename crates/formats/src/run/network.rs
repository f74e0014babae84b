use std::fmt::Write as _;

use cogmap_geometry::Pose;
use cogmap_mapping::memory::{Link, LinkKind, Mfis};
use cogmap_simulation::Session;

/// How well a link is known, one standard deviation. Mappers do not estimate it, so these are ours:
/// what a step between neighbouring places, or a recognised place, is off by in a typical run.
struct Spread {
    /// Along x and along y, metres.
    position: f64,
    /// Radians.
    heading: f64,
}

/// The robot went from one frame to the other.
const PASSAGE: Spread = Spread { position: 0.02, heading: 0.005 };
/// The robot recognised a place that it had been to.
const RECOGNISED: Spread = Spread { position: 0.05, heading: 0.01 };

/// `network.g2o`: the frames of the mapper at `index` and the links between them as a pose graph,
/// so that any optimiser can say what moving them would add. Frames stand where they lay when they
/// were opened; the first, which is the map's own, is fixed.
#[must_use]
pub fn network(session: &Session, index: usize) -> String {
    session.mappers().get(index).map_or(String::new(), |mapper| pose_graph(mapper.mfis()))
}

fn pose_graph(mfis: &Mfis) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    for frame in mfis.frames() {
        let _ = writeln!(text, "VERTEX_SE2 {} {}", frame.id.0, written(frame.map_from_frame));
    }
    let _ = writeln!(text, "FIX 0");
    for link in mfis.links() {
        let _ = writeln!(text, "{}", edge(link));
    }
    text
}

fn edge(link: &Link) -> String {
    let Link { from, to, from_from_to, kind, .. } = link;
    let Spread { position, heading } = match kind {
        LinkKind::Passage => PASSAGE,
        LinkKind::Recognised => RECOGNISED,
    };
    let [along, turn] = [position, heading].map(|spread| 1.0 / (spread * spread));
    // The upper triangle of the information matrix, row by row.
    let information = format!("{along} 0 0 {along} 0 {turn}");
    format!("EDGE_SE2 {} {} {} {information}", from.0, to.0, written(*from_from_to))
}

fn written(pose: Pose) -> String {
    // Adding zero makes a negative zero positive.
    let [x, y, heading] = [pose.position.x, pose.position.y, pose.heading].map(|number| number + 0.0);
    format!("{x} {y} {heading}")
}

#[cfg(test)]
mod tests {
    use cogmap_mapping::memory::FrameId;
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn a_link_survives_its_file(
            (from, to) in (0u32..99, 0u32..99),
            (x, y, heading) in (-1e3f64..1e3, -1e3f64..1e3, -3.1f64..3.1),
            recognised in any::<bool>(),
        ) {
            let kind = if recognised { LinkKind::Recognised } else { LinkKind::Passage };
            let from_from_to = Pose::new(x, y, heading);
            let link = Link { from: FrameId(from), to: FrameId(to), from_from_to, step: 0, kind };
            let line = edge(&link);
            let words: Vec<&str> = line.split(' ').collect();
            prop_assert_eq!(words.len(), 12);
            prop_assert_eq!(words[0], "EDGE_SE2");
            let numbers: Vec<f64> = words[1..].iter().map(|word| word.parse().unwrap()).collect();
            prop_assert_eq!(&numbers[..5], &[f64::from(from), f64::from(to), x, y, from_from_to.heading]);
            prop_assert!(numbers[5] > 0.0 && numbers[5] == numbers[8] && numbers[10] > 0.0);
            prop_assert_eq!([numbers[6], numbers[7], numbers[9]], [0.0; 3]);
        }
    }

    #[test]
    fn a_map_without_local_frames_is_one_fixed_vertex() {
        assert_eq!(pose_graph(&Mfis::default()), "VERTEX_SE2 0 0 0 0\nFIX 0\n");
    }
}
