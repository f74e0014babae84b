use cogmap_geometry::{DVec2, Segment};

use crate::{
    Anchored, OptionsParams, dead_ends::Closed, options::assumed, strategy::Situation,
    surroundings::Surroundings,
};

/// The option that is being tried.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trial {
    end: Anchored<DVec2>,
}

impl Trial {
    /// Goes for an option that ends there.
    pub(crate) fn of(end: DVec2, situation: &Situation) -> Self {
        Self { end: situation.atlas.keep(end) }
    }

    /// Where the option ends, as it lies here.
    pub(crate) fn end(self, situation: &Situation) -> Option<DVec2> {
        situation.atlas.point(self.end)
    }

    /// Where the way over the option to home has turned out closed, if it has (§3.3.2: as the robot turns
    /// toward an option it sees what it had only assumed).
    pub(crate) fn closed(
        self,
        home: DVec2,
        trusted: &Surroundings,
        params: &OptionsParams,
        situation: &Situation,
    ) -> Option<Closed> {
        let (robot, end) = (situation.belief.here_from_robot.position, self.end(situation)?);
        let radius = params.assumed_half_width;
        let there = robot.distance(end) <= params.spacing;
        let seen = (!there).then(|| Segment::new(robot, end));
        let guessed = assumed(if there { robot } else { end }, home, params.rough);
        [seen, guessed].into_iter().flatten().find_map(|way| {
            let at = trusted.first_touch(way, radius)?;
            Some(Closed { at, along: way.direction()?, radius })
        })
    }
}
