mod going_home;

use super::{
    Drawing, Figure, Runs, corridor, environments, exits, matching, movement, network, placement,
    propagation, reference, route, scan, sight, traditional,
};

const fn figure(
    id: &'static str,
    title: &'static str,
    shows: &'static str,
    make: fn(&mut Runs) -> Result<Drawing, String>,
) -> Figure {
    Figure { id, title, shows, make }
}

/// Every figure of the second and third chapters, in the order of the thesis.
pub(super) const FIGURES: [&[Figure]; 2] = [MAPPING, going_home::FIGURES];

const MAPPING: &[Figure] = &[
    figure(
        "2.1",
        "A network of local spaces",
        "Each local space is an ASR, a node of the network; exits join them. The robot finds both by \
         itself, from the map that it builds.",
        network::spaces_and_exits,
    ),
    figure(
        "2.2",
        "A route through the network",
        "To go back to a place that it knows, the robot looks for the way with the fewest exits.",
        route::through_the_network,
    ),
    figure(
        "2.3",
        "From exit to exit through a local space",
        "The network says which spaces to go through; within each of them the robot has to know where \
         the right exit is.",
        route::through_one_space,
    ),
    figure(
        "2.4",
        "Surfaces in the MFIS",
        "All that the robot keeps of where it was: straight surfaces in one world-fixed frame, each \
         as it was first seen.",
        environments::memory,
    ),
    figure(
        "2.5",
        "How an error of the movement propagates",
        "One wall, seen in three views. The wheels tell a turn that never was, the same small one in \
         each step: the map turns the wall again and again, and the errors add up.",
        propagation::of_turns,
    ),
    figure(
        "2.6",
        "A round trip made twice, mapped twice",
        "A corridor that leads back to its beginning, driven round twice with nothing but odometry: \
         the second lap is drawn beside the first.",
        propagation::two_laps,
    ),
    figure(
        "2.7",
        "The network after a round trip",
        "Eleven rooms in a ring. The twelfth on the way is the first again, entered by its other \
         door.",
        network::after_a_round_trip,
    ),
    figure(
        "2.8",
        "The MFIS after a round trip",
        "The map of the same tour in the colours of its spaces. Nothing in it is moved when a loop is \
         closed: only the network knows.",
        network::memory_of_a_round_trip,
    ),
    figure(
        "3.1",
        "From a scan to surfaces",
        "The points of one scan and the straight surfaces fitted to them. Walls become long surfaces; \
         the feet of a swivel chair, encircled, become a few short ones that say little: debris.",
        scan::surfaces,
    ),
    figure(
        "3.2",
        "Two views, put together by the movement",
        "The robot looks, turns, travels and looks again. Moved by exactly that turn and travel, the \
         first view lies on the second.",
        movement::transformation,
    ),
    figure(
        "3.3",
        "A slight error of the movement, a misplaced surface",
        "The same two views put together by a movement that is slightly wrong: what only the second \
         view saw enters the map in the wrong place.",
        movement::bad_placement,
    ),
    figure(
        "3.4",
        "Measuring a pair of surfaces, and correcting by it",
        "How badly two surfaces fit: the distances d1 and d2 of their ends and the angle φ between \
         them, multiplied. Right: the traditional mapper changes turn and travel at random and keeps \
         what lowers the mean error of all pairs.",
        matching::pair,
    ),
    figure(
        "3.5",
        "The good robot in a small environment",
        "The traditional mapper, one colour a view. In a small office its correction is enough.",
        traditional::small_good,
    ),
    figure(
        "3.6",
        "The bad robot in a small environment",
        "The same office and mapper with the bad robot. A surface that is not recognised again is \
         drawn twice.",
        traditional::small_bad,
    ),
    figure(
        "3.7",
        "The large environment",
        "The building of the next two maps, and the way that the robot was driven: a loop that ends \
         where it began.",
        traditional::large_plan,
    ),
    figure(
        "3.8",
        "The good robot in the large environment",
        "The traditional mapper on the loop. If it made no error, the ends of its map would meet.",
        traditional::large_good,
    ),
    figure(
        "3.9",
        "The bad robot in the large environment",
        "The same loop and mapper with the bad robot: the errors of more than a hundred corrected \
         movements add up.",
        traditional::large_bad,
    ),
    figure(
        "3.10",
        "Surfaces judged to be the same",
        "The previous view, moved by a rough guess, over the current one. What lies near enough and \
         is turned little enough is taken for the same surface, though it does not quite overlap.",
        matching::views,
    ),
    figure(
        "3.11",
        "Surfaces in the current view",
        "What the robot sees after a step, seen from itself: a surface that it recognises, which \
         becomes the reference, and one that is new.",
        placement::view,
    ),
    figure(
        "3.12",
        "The MFIS when a new surface is placed",
        "The same step in the map: distance and angle from the reference to the new surface are \
         carried over as they were seen. The measured movement has no part in it.",
        placement::memory,
    ),
    figure(
        "3.13",
        "A narrow passage separates two spaces",
        "Where the way is narrow between two wide parts there is an exit, and another space begins; \
         where nothing is narrow there is none.",
        exits::narrow_or_not,
    ),
    figure(
        "3.14",
        "How wide it is along the way",
        "On its way the robot measures how far it is from what is on its left to what is on its \
         right. A minimum of that is an exit, found once it has been crossed.",
        exits::wideness,
    ),
    figure(
        "3.15",
        "Surfaces seen through an exit",
        "R1 already sees part of the next space. Once the robot is behind the exit, at R2, what was \
         seen through the passage itself goes over to the new space; the line through the exit alone \
         would not do.",
        sight::across_the_exit,
    ),
    figure(
        "3.16",
        "Placing surfaces in the MFIS",
        "The bad robot in a long office, one colour a view. Long surfaces should lie on the walls, \
         and each wall should be there once.",
        environments::placement,
    ),
    figure(
        "3.17",
        "A bad reference",
        "A round pillar, seen from two places: the straight surface fitted to it is another one each \
         time. Whoever takes both for the same takes over the difference.",
        reference::changing_shape,
    ),
    figure(
        "3.18",
        "Displaced by a bad reference",
        "The second view laid over the first by a good reference and by the pillar: the pillar’s \
         error turns everything that is placed by it, the farther away the more.",
        reference::displacement,
    ),
    figure(
        "3.19",
        "The MFIS of large environment A",
        "120 m with the bad robot through large rooms and long corridors. No error is corrected; \
         where the loop ends, it should meet its beginning.",
        environments::map_a,
    ),
    figure(
        "3.20",
        "Large environment A",
        "The building of that map and the way through it, a loop that ends where it began.",
        environments::plan_a,
    ),
    figure(
        "3.21",
        "What the laser sees in a corridor",
        "Two parallel walls and no end within reach: nothing tells how far along the corridor the \
         robot has come.",
        corridor::nothing_in_view,
    ),
    figure(
        "3.22",
        "The MFIS of large environment B",
        "The loop on which the traditional mapper was tried, with the bad robot, mapped without any \
         correction.",
        environments::map_b,
    ),
    figure(
        "3.23",
        "Large environment B",
        "The building of that map and the way through it.",
        environments::plan_b,
    ),
    figure(
        "3.24",
        "Environment B separated into local spaces",
        "The map of the same drive in the colours of its ASRs, with their numbers and exits. Where \
         the loop is found, beginning and end are one space.",
        network::separated,
    ),
];
