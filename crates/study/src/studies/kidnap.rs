use super::{CONSENSUS, consensus, courses, grid, perceptual, robots, transform};
use crate::{Bound, Check, Course, Outcome, Study};

/// Moved unseen: successive views do not overlap (§2.1, §2.2.2).
pub(crate) const STUDY: Study = Study {
    name: "kidnap",
    line: "moved unseen to another room: noticed, not mapped silently, and found again?",
    about: "Somewhere in the middle of the loop of 90 m the robot is picked up and set down in another room of its \
            route, wheels still, and the drive goes on from there. The theory says that views must overlap, or \
            the robot is lost (§2.1, §2.2.2); it says nothing of noticing it. Judged: whether the robot says \
            within 3 scans that it is not where it believed to be, whether it mapped anything into the old \
            place before, and whether it finds a place again that it knew. The thesis's form and the \
            traditional one have no sense of being lost.",
    seeds: 1000,
    shown: &["noticed", "noticed_after", "mapped_silently", "found_again", "fallbacks"],
    plan: |request| {
        let kidnapped = |course: Course| Course { kidnap: true, ..course };
        let courses: Vec<Course> =
            courses(request, "environment-b", "loop")?.into_iter().map(kidnapped).collect();
        Ok(grid(&courses, &robots(&["bad"]), &[transform(), perceptual(), consensus()]))
    },
    judge,
};

fn judge(outcome: &Outcome) -> Vec<Check> {
    let check = |group: crate::Group<'_>| {
        [
            Check::share(
                format!("{CONSENSUS}: noticed within 3 scans in at least 95 % of runs"),
                group.figure_of("noticed"),
                Bound::AtLeast(0.95),
            ),
            Check::share(
                format!("{CONSENSUS}: something mapped into the old place before in at most 1 % of runs"),
                group.figure_of("mapped_silently"),
                Bound::AtMost(0.01),
            ),
        ]
    };
    outcome.groups_of("bad", CONSENSUS).flat_map(check).collect()
}
