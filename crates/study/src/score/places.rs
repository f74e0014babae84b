use cogmap_mapping::Event;

use super::{Values, count};
use crate::Mapping;

/// What became of the network of local spaces.
pub(super) fn score(mapping: &Mapping, values: &mut Values) {
    let Mapping { mapper, reports, .. } = mapping;
    values.put("frames", count(mapper.mfis().frames().len()));
    values.put("recognised", count(reports.iter().filter(|report| report.recalled.is_some()).count()));
    let Some(network) = mapper.network() else { return };
    values.put("asrs", count(network.asrs().len()));
    values.put("exits", count(network.exits().len()));
    let mut events =
        reports.iter().filter_map(|report| report.place.as_ref()).flat_map(|place| &place.events);
    let closed = events.any(|event| matches!(event, Event::LoopClosed { .. }));
    values.put("loop_closed", f64::from(u8::from(closed)));
}
