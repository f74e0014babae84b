use cogmap_formats::relations::Relation;
use cogmap_simulation::{Recording, Stamped};

use super::{Values, count, odometry};
use crate::{
    Mapping,
    metrics::relations::{densify, in_map, mean_error, network_error},
};

/// Every measure of what a mapper made of a log, whose truth is only known from relations.
#[must_use]
pub fn score_log(recording: &Recording, mapping: &Mapping, relations: &[Relation]) -> Values {
    let mut values = Values::default();
    let mfis = mapping.mapper.mfis();
    values.put("surfaces", count(mfis.surfaces().len()));
    values.put(
        "surfaces_long",
        count(mfis.surfaces().iter().filter(|s| s.segment.length() >= super::LONG).count()),
    );
    odometry::score(mapping, &mut values);
    let stamped = |reading: &cogmap_mapping::perception::Reading| Stamped {
        t: reading.t,
        pose: reading.odom_from_robot,
    };
    let at_views: Vec<Stamped> = recording.readings.iter().map(stamped).collect();
    let dense = densify(mapping.mapper.path(), &at_views, &recording.odometry);
    values.put("relations", mean_error(relations, &in_map(&dense, mfis)).map(|error| error.mean));
    values.put("relations_network", network_error(relations, &dense, mfis).map(|error| error.mean));
    values.put("frames", count(mfis.frames().len()));
    let recalled = mapping.reports.iter().filter(|report| report.recalled.is_some());
    values.put("recognised", count(recalled.count()));
    values
}
