use cogmap_mapping::{MapperSetup, memory::ConsensusParams};

use super::{consensus, courses, grid, relations, robots};
use crate::{Condition, Study, Treatment, Variant};

/// Our form without each of its extensions.
pub(crate) const STUDY: Study = Study {
    name: "ablation",
    line: "our form without each of the things that it adds to the theory",
    about: "The bad robot drives the loop of 90 m, and `consensus` maps it as it is and with one extension \
            switched off at a time. What gets worse without it is what the extension is for. With --log and \
            --relations the same is done to a real log.",
    seeds: 100,
    shown: &[
        "shape",
        "gap",
        "heading_gap",
        "pieces",
        "displaced",
        "fallbacks",
        "partly",
        "recognised",
        "relations",
    ],
    plan: |request| {
        let params = ConsensusParams::default();
        let without = params.ablations().into_iter().map(|(name, params)| {
            Variant::new(&format!("without {name}"), MapperSetup::Consensus(Box::new(params)))
        });
        let mappers: Vec<Variant> = std::iter::once(consensus()).chain(without).collect();
        let courses = courses(request, "environment-b", "loop")?;
        let drives = grid(&courses, &robots(&["bad"]), &mappers);
        let noise = request.noise.first().copied().unwrap_or(1.0);
        let treatment = [Treatment { odometry: noise, every: None }];
        let logs = request.log.iter().flat_map(|log| relations::of_log(log, &treatment));
        let logs = logs.map(|condition| Condition { mappers: mappers.clone(), ..condition });
        Ok(drives.into_iter().chain(logs).collect())
    },
    judge: |_| Vec::new(),
};
