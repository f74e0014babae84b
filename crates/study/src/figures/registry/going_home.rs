use super::{Figure, figure};
use crate::figures::{corner, courses, dead_ends, forgetting, options, remembered};

/// The figures of §3.3, in the order of the thesis.
pub(super) const FIGURES: &[Figure] = &[
    figure(
        "3.25",
        "Movement options in a narrow place",
        "Where can the robot go? Each green line is a way that it sees to be free; from its end it \
         assumes a straight way home, blue and dashed, that nothing crosses which it trusts. Where it is \
         narrow there are few.",
        options::in_a_narrow_place,
    ),
    figure(
        "3.26",
        "Movement options in a wide place",
        "The more room there is, the more ways on the robot has to choose from.",
        options::in_a_wide_place,
    ),
    figure(
        "3.27",
        "Moving away from a dead end",
        "The robot wanted to go straight home, turned and saw a wall. On its left and below nothing is \
         wide enough for it: all options lead back up.",
        options::out_of_a_dead_end,
    ),
    figure(
        "3.28",
        "The most promising option",
        "The same moment as in Fig. 3.26. Of all options the robot takes the one that makes the \
         straightest line home, and looks again after a step of it.",
        options::the_most_promising,
    ),
    figure(
        "3.29",
        "Forgetting old geometry on the way",
        "The robot trusts only what it saw lately or what is near. A surface is forgotten when it is more \
         than 5 m away and none of the last five looks showed it; the map itself keeps it.",
        forgetting::on_the_way,
    ),
    figure(
        "3.30",
        "Stuck by a wrong surface",
        "What is near is never forgotten, even where it is wrong.",
        forgetting::by_a_wrong_surface,
    ),
    figure(
        "3.31",
        "Moving away from the end of a bay",
        "A bay lies open toward the robot, and home lies behind its closed end.",
        dead_ends::away_from_it,
    ),
    figure(
        "3.32",
        "Exploring the dead end again",
        "A few steps later the end of the bay is far, has not been seen lately and is forgotten; the way \
         through it is the straightest again.",
        dead_ends::into_it_again,
    ),
    figure(
        "3.33",
        "Waypoints of the way home",
        "Of the way out the robot keeps a few waypoints such that from each to the next it is about \
         straight. Most of the map behind them has been forgotten.",
        remembered::waypoints,
    ),
    figure(
        "3.34",
        "Shortcuts in a path",
        "The way out winds through three halls and passes two open doorways. On the way home the robot \
         tries whatever leads toward home, also through places where it has never been.",
        remembered::two_shortcuts,
    ),
    figure(
        "3.35",
        "Home around a corner",
        "A person drives the robot round what stands in the middle; then it goes home by itself.",
        corner::there_and_back,
    ),
    figure(
        "3.36",
        "What was seen and what was not",
        "The laser looks ahead only. When the robot is told to go home it knows one side of what stands \
         in the middle; in its memory the other side is a hole.",
        corner::what_was_seen,
    ),
    figure(
        "3.37",
        "A way through the wall?",
        "The straightest option leads through what was never seen. The robot turns toward it, looks, and \
         the option is gone.",
        corner::false_opening,
    ),
    figure(
        "3.38",
        "Home by a shortcut",
        "Out through a corridor, home through a door that the robot has never used.",
        courses::shortcut,
    ),
    figure(
        "3.39",
        "Home around obstacles",
        "The only way home winds through rows of boxes. There the sense of direction fails, and the \
         robot follows the way that it remembers; in the open hall it finds home by its sense of direction.",
        courses::around_the_boxes,
    ),
    figure(
        "3.40",
        "A dense collection of obstacles",
        "Around the boxes everything is near or was seen lately, so nothing that matters is forgotten, and no \
         way of two straight lines leads out.",
        courses::among_the_boxes,
    ),
];
