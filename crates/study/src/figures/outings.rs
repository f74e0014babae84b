//! The drives that figures are drawn from; those of the thesis's experiments bear its numbers.

use super::runs::{Building, Outing, UNAIDED};

/// §3.1.4, a small environment: 6 m in 8 steps.
pub(super) const SMALL_GOOD: Outing = Outing {
    place: "the small office",
    building: Building::Named("small-office"),
    route: "tour",
    robot: "good",
    mappers: &["transform"],
};
pub(super) const SMALL_BAD: Outing =
    Outing { robot: "bad", mappers: &["transform", "perceptual"], ..SMALL_GOOD };

/// §3.1.4 and §3.2.3, large environment B: a loop of 90 m.
pub(super) const LARGE_GOOD: Outing = Outing {
    place: "environment B",
    building: Building::Named("environment-b"),
    route: "loop",
    robot: "good",
    mappers: &["transform"],
};
pub(super) const LARGE_BAD: Outing =
    Outing { robot: "bad", mappers: &["transform", "perceptual", "consensus", UNAIDED], ..LARGE_GOOD };

/// §3.2.3, surface placement: 15 m in 34 steps.
pub(super) const LONG_OFFICE: Outing = Outing {
    place: "the long office",
    building: Building::Named("long-office"),
    route: "tour",
    robot: "bad",
    mappers: &["perceptual", UNAIDED],
};

/// §3.2.3, large environment A: a loop of 120 m.
pub(super) const ENVIRONMENT_A: Outing = Outing {
    place: "environment A",
    building: Building::Named("environment-a"),
    route: "loop",
    ..LONG_OFFICE
};

/// §2.3: twelve local spaces, the last of which is part of the first.
pub(super) const TOUR: Outing = Outing {
    place: "a tour of twelve spaces",
    building: Building::Named("tour"),
    route: "tour",
    robot: "bad",
    mappers: &["consensus"],
};

/// §3.2.2: the same walk through a narrow passage and where there is none.
pub(super) const NARROW: Outing = Outing {
    place: "two spaces and a narrow passage",
    building: Building::Named("narrow-passage"),
    route: "across",
    robot: "bad",
    mappers: &["perceptual"],
};
pub(super) const NOT_NARROW: Outing =
    Outing { place: "one space without a passage", building: Building::Named("no-passage"), ..NARROW };

/// §3.2.3: a corridor longer than the laser sees.
pub(super) const CORRIDOR: Outing =
    Outing { place: "a long corridor", building: Building::Named("long-corridor"), route: "there", ..NARROW };

/// §2.3: a corridor around a block, driven round twice.
pub(super) const RING: Outing = Outing {
    place: "a corridor around a block",
    building: Building::Made(
        r#"{"format": "cogmap-world/1", "name": "Ring", "start": {"position": [1, 1], "heading_deg": 0},
        "walls": [[[0, 0], [11, 0], [11, 8], [0, 8], [0, 0]], [[2, 2], [9, 2], [9, 6], [2, 6], [2, 2]]],
        "routes": {"two laps": [
            [2.5, 1], [4.5, 1], [6.5, 1], [8.5, 1], [10, 1], [10, 2.5], [10, 4], [10, 5.5], [10, 7],
            [8.5, 7], [6.5, 7], [4.5, 7], [2.5, 7], [1, 7], [1, 5.5], [1, 4], [1, 2.5], [1, 1],
            [2.5, 1], [4.5, 1], [6.5, 1], [8.5, 1], [10, 1], [10, 2.5], [10, 4], [10, 5.5], [10, 7],
            [8.5, 7], [6.5, 7], [4.5, 7], [2.5, 7], [1, 7], [1, 5.5], [1, 4], [1, 2.5], [1, 1]]}}"#,
    ),
    route: "two laps",
    robot: "bad",
    mappers: &["odometry"],
};

/// §3.2.2: a room beside a larger one that reaches round its corner.
pub(super) const SIDE_ROOM: Outing = Outing {
    place: "a room made for it",
    building: Building::Made(
        r#"{"format": "cogmap-world/1", "name": "Side room", "start": {"position": [0.8, 2.2], "heading_deg": 0},
        "walls": [[[0, 0], [9, 0], [9, 5.4], [0, 5.4], [0, 0]],
            [[4.34, 5.4], [4.34, 4.2], [4.46, 4.2], [4.46, 5.4]],
            [[9, 1.7], [4.34, 1.7], [4.34, 3.2], [4.46, 3.2], [4.46, 1.82], [9, 1.82]]],
        "boxes": [{"center": [7.2, 4.9], "size": [1.2, 0.6]}, {"center": [8.2, 0.3], "size": [0.7, 0.5]},
            {"center": [1.0, 4.9], "size": [1.0, 0.6]}],
        "routes": {"in": [[1.6, 2.6], [2.4, 3.1], [3.2, 3.6], [4.0, 3.7], [4.8, 3.7], [5.6, 3.6], [6.3, 3.4]]}}"#,
    ),
    route: "in",
    robot: "good",
    mappers: &["perceptual"],
};

/// §3.3.5, home round a corner: 10 m.
pub(super) const CORNER: Outing = Outing {
    place: "round a corner",
    building: Building::Named("around-a-corner"),
    route: "tour",
    robot: "bad",
    mappers: &["consensus"],
};

/// §3.3.5, a shortcut: 30 m.
pub(super) const SHORTCUT: Outing =
    Outing { place: "two offices", building: Building::Named("shortcut"), ..CORNER };

/// §3.3.5, a narrow obstacle course: 50 m.
pub(super) const BOXES: Outing =
    Outing { place: "a course of boxes", building: Building::Named("box-course"), ..CORNER };

/// §3.3.3: a bay that is open toward the robot and closed toward its home.
pub(super) const BAY: Outing =
    Outing { place: "a hall with a bay", building: Building::Named("u-trap"), ..CORNER };

/// §3.3.4: three halls, and two doorways that the way out passes by.
pub(super) const HALLS: Outing =
    Outing { place: "three halls", building: Building::Named("two-shortcuts"), ..CORNER };

/// The same with the thesis's own program for a mapper, whose map bends.
pub(super) const BENT_SHORTCUT: Outing = Outing { mappers: &["perceptual"], ..SHORTCUT };
pub(super) const BENT_HALLS: Outing = Outing { mappers: &["perceptual"], ..HALLS };

/// §3.3.2: a place that is open at its back only, as seen from the way home.
pub(super) const POCKET: Outing = Outing {
    place: "a pocket made for it",
    building: Building::Made(
        r#"{"format": "cogmap-world/1", "name": "Pocket", "start": {"position": [17.5, 5.5], "heading_deg": 110},
        "walls": [[[0, 2], [20, 2], [20, 10], [0, 10], [0, 2]],
            [[13.5, 2], [13.5, 7.2], [13.62, 7.2], [13.62, 2]],
            [[4.6, 6.4], [9.6, 6.4], [9.6, 2], [9.72, 2], [9.72, 6.52], [4.6, 6.52], [4.6, 6.4]]],
        "boxes": [{"center": [19.6, 3.2], "size": [0.6, 1.6]}, {"center": [16, 2.4], "size": [1.4, 0.6]},
            {"center": [11.6, 2.4], "size": [1.6, 0.6]}, {"center": [7.4, 9.7], "size": [1.6, 0.5]},
            {"center": [0.35, 8.6], "size": [0.6, 1.2]}, {"center": [5.6, 2.35], "size": [1.2, 0.6]}],
        "routes": {"in": [[17.2, 6.6], [16.4, 7.8], [15.2, 8.5], [13.8, 8.6], [12.4, 8.5], [11, 8.3], [9.6, 8.2],
            [8.2, 8.2], [6.8, 8.2], [5.4, 8.1], [4, 7.9], [2.8, 7.3], [2.4, 6.3], [2.8, 5.4], [3.6, 4.8], [4.3, 4.6],
            [3.6, 4.2]]}}"#,
    ),
    route: "in",
    ..CORNER
};
