use serde::Serialize;

/// A column of `runs.csv`: one number that a run is judged by.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Measure {
    /// The column's name; it never changes its meaning.
    pub name: &'static str,
    /// The same, short, for the table on screen.
    pub head: &'static str,
    /// Its unit; empty for counts and shares.
    pub unit: &'static str,
    /// One line for people.
    pub meaning: &'static str,
    /// How many runs are put together.
    #[serde(skip)]
    pub kind: Kind,
}

/// How the values of many runs become one figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// The median with its bootstrap interval.
    Median,
    /// 1 where it happened and 0 where not: a rate with Wilson's interval.
    Rate,
    /// Part of another column: the sum over the sum, with its bootstrap interval over runs.
    Part(&'static str),
    /// Over another column, and no part of it: the same.
    Ratio(&'static str),
}

impl Measure {
    /// The measure of that name.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        MEASURES.iter().find(|measure| measure.name == name)
    }
}

const fn median(
    name: &'static str,
    head: &'static str,
    unit: &'static str,
    meaning: &'static str,
) -> Measure {
    Measure { name, head, unit, meaning, kind: Kind::Median }
}

const fn rate(name: &'static str, head: &'static str, meaning: &'static str) -> Measure {
    Measure { name, head, unit: "", meaning, kind: Kind::Rate }
}

const fn part(name: &'static str, head: &'static str, of: &'static str, meaning: &'static str) -> Measure {
    Measure { name, head, unit: "", meaning, kind: Kind::Part(of) }
}

const fn ratio(name: &'static str, head: &'static str, of: &'static str, meaning: &'static str) -> Measure {
    Measure { name, head, unit: "", meaning, kind: Kind::Ratio(of) }
}

/// Every measure, in the order of the columns.
#[rustfmt::skip]
pub const MEASURES: [Measure; 77] = [
    rate("arrived", "arrived", "the person at the controls came to the end of the route"),
    median("way", "way", "m", "length of the true way"),
    median("steps", "steps", "", "movement steps"),
    median("views", "views", "", "views that the mapper took in"),
    part("views_stored", "stored", "views", "views of which at least one surface was stored"),
    median("surfaces", "surfaces", "", "surfaces in the map"),
    median("surfaces_long", "long", "", "surfaces in the map of at least 1 m"),
    median("shape", "shape", "m", "rms distance of the way in the map from the true one, laid on it as well as can be"),
    median("shape_share", "shape %", "%", "shape as a share of the way"),
    median("side_angle", "sides", "°", "rms turn of the long walls, the map laid by its whole way"),
    median("gap", "gap", "m", "closing gap: how far from where it believes to be the robot stands at the end"),
    median("gap_share", "gap %", "%", "closing gap as a share of the way"),
    median("heading_gap", "turned", "°", "how far the robot is turned from where it believes to look at the end"),
    median("displacement", "displ.", "m", "median displacement of long surfaces from their walls, the map laid by its first view"),
    part("displaced_first", ">0.5 first", "walls_named", "long surfaces displaced by more than 0.5 m, the map laid by its first view"),
    part("displaced", ">0.5 m", "walls_named", "long surfaces displaced by more than 0.5 m, the map laid by its whole way"),
    median("walls_named", "named", "", "long surfaces whose true wall is known"),
    part("displaced_any_first", ">0.5 any, first", "any_named", "surfaces of any length displaced by more than 0.5 m, the map laid by its first view"),
    part("displaced_any", ">0.5 any", "any_named", "surfaces of any length displaced by more than 0.5 m, the map laid by its whole way"),
    median("any_named", "any named", "", "surfaces of any length whose true wall is known"),
    ratio("pieces", "per wall", "walls", "pieces per true long wall, once those are joined that go on from each other; 1 is ideal"),
    median("walls", "walls", "", "true long walls that stand in the map"),
    ratio("length_mapped", "length ×", "length_shown", "metres of long surfaces over metres of true wall that they show; 1 is ideal"),
    median("length_shown", "shown", "m", "metres of true wall that the long surfaces show"),
    rate("blocked", "blocked", "a surface of the map stands in the way that the robot drove"),
    median("blocked_steps", "bl. steps", "", "steps of the driven way that would run into a surface of the map"),
    rate("blocked_then", "bl. then", "a surface stands in the way, of those that the map held when the robot drove there"),
    median("weak", "weak", "", "views placed by a reference whose place along its own line was a guess"),
    median("fallbacks", "fallbacks", "", "views placed by odometry because nothing was recognised"),
    part("fallbacks_excused", "f. excused", "fallbacks", "of the fallbacks those in which what was in view could not tell where the robot is: nothing, or parallel walls"),
    median("partly", "partly", "", "views in which odometry decided along a direction"),
    part("partly_excused", "p. excused", "partly", "of the views partly by odometry those in which what was in view left a direction open: nothing, or parallel walls"),
    median("longest_fallback", "longest", "m", "longest stretch of the way placed by odometry alone"),
    median("error_2", "2 m", "m", "rms error over stretches of 2 m"),
    median("error_4", "4 m", "m", "rms error over stretches of 4 m"),
    median("error_8", "8 m", "m", "rms error over stretches of 8 m"),
    median("error_16", "16 m", "m", "rms error over stretches of 16 m"),
    median("error_32", "32 m", "m", "rms error over stretches of 32 m"),
    median("error_64", "64 m", "m", "rms error over stretches of 64 m"),
    median("rectangle", "rectangle", "m", "rms distance of the surfaces of the room's outline from a rectangle"),
    median("rectangle_angle", "sides", "°", "rms turn of those surfaces from the rectangle's sides"),
    median("asrs", "ASRs", "", "local spaces in the network"),
    median("exits", "exits", "", "exits in the network"),
    rate("loop_closed", "loop", "the network closed a loop"),
    median("recognised", "recogn.", "", "times that the robot found itself back in a place that it knew"),
    median("frames", "frames", "", "local frames of the map"),
    median("doorways", "doorways", "", "times that the robot truly went through a doorway"),
    part("exits_found", "found", "doorways", "doorways that the robot went through for which an exit was found, at most 0.5 m off"),
    median("exits_crossed", "crossed", "", "times that the robot says it went through an exit"),
    part("exits_true", "true", "exits_crossed", "exits that the robot says it went through that are doorways"),
    median("exit_error", "off", "m", "median distance of a found exit from its doorway"),
    median("rooms", "rooms", "", "rooms that the robot was in"),
    rate("asrs_fit", "ASRs ±25 %", "as many local spaces as rooms, to a quarter"),
    median("revisits", "revisits", "", "times that the robot came back into a room"),
    part("revisits_known", "known", "revisits", "returns into a room in which the robot knew the room's space again"),
    median("new_places", "new", "", "times that the robot came into a room for the first time"),
    part("false_closures", "false", "new_places", "rooms entered for the first time that the robot took for one that it knew"),
    rate("home_known", "home", "the space at the end is the one at the start, as the rooms are"),
    median("network_edits", "edits", "", "nodes and passages to add or take away until the network is the rooms' graph"),
    median("purity", "purity", "%", "share of surfaces, by length, that bound the room that most of their space's do"),
    median("room_recall", "room rec.", "%", "mean over rooms of the largest share of its surfaces that one space holds"),
    median("room_precision", "room prec.", "%", "mean over spaces of the largest share of its surfaces that bound one room"),
    median("room_f1", "room F1", "", "rooms and spaces paired where intersection over union is at least a half"),
    median("rand", "Rand", "", "adjusted Rand index of surfaces shared out among spaces and rooms"),
    rate("noticed", "noticed", "the robot noticed within 3 scans that it had been moved unseen"),
    median("noticed_after", "scans", "", "scans after which the robot noticed, where it did"),
    rate("mapped_silently", "silently", "the robot mapped something into the old place before it noticed"),
    rate("found_again", "found", "the robot found a place again that it knew from before"),
    median("relations", "relations", "m", "mean error against relations matched by hand, of the trajectory as it was believed online"),
    median("relations_network", "network", "m", "the same of relations read from the network of frames"),
    rate("home_reached", "home reached", "told to go home, the robot stopped by itself within 1.5 m of its start and touched nothing"),
    median("home_distance", "from home", "m", "how far from its start in truth the way home ended"),
    rate("help_needed", "needs help", "the robot gave up and waited for its user, or wandered for half an hour"),
    rate("shortcut_taken", "shortcut", "where the shortest way home is at most 0.7 of the way out: the robot came home by less than halfway between the two"),
    median("dead_ends", "dead ends", "", "dead ends noticed on the way home"),
    rate("dead_ends_left", "left", "where a dead end was noticed: the robot came home all the same"),
    rate("home_collided", "touched", "the robot touched something on the way home"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_stands_once_and_every_part_is_of_another_column() {
        for (index, measure) in MEASURES.iter().enumerate() {
            assert!(MEASURES[..index].iter().all(|other| other.name != measure.name), "{}", measure.name);
            if let Kind::Part(of) | Kind::Ratio(of) = measure.kind {
                assert!(Measure::named(of).is_some(), "{of}");
            }
        }
    }
}
