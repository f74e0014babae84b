//! Requirements on alignment: what was stored of a wall speaks together.

use super::*;
use crate::memory::consensus::known::Known;

fn wall(tag: u32, middle: DVec2, heading: f64, length: f64) -> Line {
    let (sin, cos) = trig::sin_cos(heading);
    let along = DVec2::new(cos, sin);
    let (ends, variance, spacing) = ([End::Occlusion; 2], 1e-5, 0.02);
    Line {
        tag,
        a: middle - along * (length / 2.0),
        along,
        heading,
        length,
        ends,
        variance,
        spacing,
        label: None,
    }
}

#[test]
fn a_wall_stored_twice_is_believed_to_stand_between_its_two_pieces() {
    let degree = trig::PI / 180.0;
    let middle = DVec2::new(0.0, 1.0);
    let known: Known =
        [-degree, degree].into_iter().zip(0..).map(|(h, tag)| wall(tag, middle, h, 4.0)).collect();
    let view = [wall(0, middle, 0.0, 4.0)];
    for guess in [-1.5 * degree, 0.5 * degree, 1.5 * degree] {
        let start = Pose::new(0.0, 0.0, guess);
        let near = Candidates::around(&view, &known, start, 0.8, 20.0 * degree);
        let fit = align(&view, &near, start, 0.0, &Alignment::default());
        assert!(fit.pose.heading.abs() < 0.05 * degree, "{guess} {:?}", fit.pose);
        assert_eq!(fit.matches.len(), 1, "what is seen is one thing");
    }
}

#[test]
fn two_things_told_apart_by_sight_are_never_laid_on_each_other() {
    let middle = DVec2::new(0.0, 1.0);
    let labelled = |label, across: f64| Line { label, ..wall(0, middle + DVec2::new(0.0, across), 0.0, 4.0) };
    for (mine, others, laid) in [(None, Some(2), true), (Some(2), Some(2), true), (Some(1), Some(2), false)] {
        let known: Known = std::iter::once(labelled(others, 0.1)).collect();
        let view = [labelled(mine, 0.0)];
        let near = Candidates::around(&view, &known, Pose::IDENTITY, 0.8, 0.3);
        let fit = align(&view, &near, Pose::IDENTITY, 0.0, &Alignment::default());
        assert_eq!(fit.matched > 0.0, laid, "{mine:?} {others:?}");
    }
}
