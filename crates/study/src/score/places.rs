use std::collections::BTreeMap;

use cogmap_geometry::DVec2;
use cogmap_mapping::{
    Event,
    places::{AsrId, Network},
};

use super::{Truth, Values, count};
use crate::{
    Drive, Mapping,
    metrics::{
        Doorway, Labelled, PlaceGraph, Rate, Visit, doorways, median, network_edits, room_at, score_division,
        score_exits, score_loops,
    },
};

/// A surface is of the room on that side of it on which the robot saw it, so far from it, metres.
const BEFORE_WALL: f64 = 0.2;
/// The number of spaces may differ from that of the rooms by this share.
const SPACES_OFF: f64 = 0.25;

/// What became of the network of local spaces.
pub(super) fn score((drive, mapping): (&Drive, &Mapping), truth: &Truth, values: &mut Values) {
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
    if truth.rooms.is_empty() {
        return;
    }
    put_exits(drive, mapping, (network, truth), values);
    put_visits(&visits(drive, mapping, (network, truth)), network, values);
    put_division(drive, mapping, (network, truth), values);
}

/// Exits against the doorways that the robot truly went through.
fn put_exits(drive: &Drive, mapping: &Mapping, (network, truth): (&Network, &Truth), values: &mut Values) {
    let path: Vec<DVec2> = drive.looks.iter().map(|look| look.world_from_robot.position).collect();
    let mut along = vec![0.0];
    for pair in path.windows(2) {
        along.push(along.last().copied().unwrap_or(0.0) + pair[0].distance(pair[1]));
    }
    let crossed = network.crossings().iter().filter_map(|crossing| {
        let look = *mapping.look_of_report.get(crossing.view)?;
        let exit = drive.looks.get(look)?.world_from_robot * crossing.robot_from_exit;
        Some(Doorway { at: exit.midpoint(), way: along[look] })
    });
    let score = score_exits(&doorways(&truth.rooms, &path), &crossed.collect::<Vec<_>>());
    put_rate("exits_found", "doorways", score.recall, values);
    put_rate("exits_true", "exits_crossed", score.precision, values);
    values.put("exit_error", median(&score.errors));
}

/// The rooms that the robot truly came into, and the space that it took each for.
fn visits(drive: &Drive, mapping: &Mapping, (network, truth): (&Network, &Truth)) -> Vec<Visit> {
    let mut visits: Vec<(usize, Vec<AsrId>)> = Vec::new();
    for (report, &look) in mapping.reports.iter().zip(&mapping.look_of_report) {
        let at = drive.looks[look].world_from_robot.position;
        let (Some(room), Some(asr)) = (room_at(&truth.rooms, at), network.asr_at(report.step)) else {
            continue;
        };
        let asr = network.lasting(asr);
        match visits.last_mut() {
            Some((last, asrs)) if *last == room => asrs.push(asr),
            _ => visits.push((room, vec![asr])),
        }
    }
    let visit =
        |(room, asrs): &(usize, Vec<AsrId>)| Visit { room: number(*room), asr: most_frequent(asrs).0 };
    visits.iter().map(visit).collect()
}

fn most_frequent(asrs: &[AsrId]) -> AsrId {
    let mut times: BTreeMap<AsrId, usize> = BTreeMap::new();
    asrs.iter().for_each(|asr| *times.entry(*asr).or_default() += 1);
    // Of equally many the oldest.
    let most = times.iter().max_by(|a, b| a.1.cmp(b.1).then(b.0.cmp(a.0)));
    most.map_or(AsrId(0), |(asr, _)| *asr)
}

/// The visits that an exit led to. A room that the robot came into without noticing an exit belongs to
/// the space before: that is an exit not found, not a loop closed.
fn through_exits(visits: &[Visit]) -> Vec<Visit> {
    let before = std::iter::once(None).chain(visits.iter().map(|visit| Some(visit.asr)));
    visits
        .iter()
        .zip(before)
        .filter(|(visit, before)| Some(visit.asr) != *before)
        .map(|(visit, _)| *visit)
        .collect()
}

fn put_visits(visits: &[Visit], network: &Network, values: &mut Values) {
    let score = score_loops(&through_exits(visits));
    put_rate("revisits_known", "revisits", score.recall, values);
    put_rate("false_closures", "new_places", score.false_closures, values);
    if let (Some(first), Some(last)) = (visits.first(), visits.last())
        && visits.len() > 1
        && first.room == last.room
    {
        values.put("home_known", f64::from(u8::from(first.asr == last.asr)));
    }
    let mut rooms: Vec<u32> = visits.iter().map(|visit| visit.room).collect();
    let passages: Vec<(u32, u32)> = rooms.windows(2).map(|pair| (pair[0], pair[1])).collect();
    rooms.sort_unstable();
    rooms.dedup();
    values.put("rooms", count(rooms.len()));
    let (asrs, wanted) = (count(network.asrs().len()), count(rooms.len()));
    values.put("asrs_fit", f64::from(u8::from((asrs - wanted).abs() <= SPACES_OFF * wanted)));
    let mut passages: Vec<(u32, u32)> = passages.iter().map(|&(a, b)| (a.min(b), a.max(b))).collect();
    passages.sort_unstable();
    passages.dedup();
    let room_of: BTreeMap<u32, u32> = visits.iter().rev().map(|visit| (visit.asr, visit.room)).collect();
    let nodes: Vec<u32> = network.asrs().iter().map(|asr| asr.id.0).collect();
    let edges: Vec<(u32, u32)> =
        network.exits().iter().map(|exit| (exit.between[0].0, exit.between[1].0)).collect();
    let edits =
        network_edits(&PlaceGraph::new(&rooms, &passages), &PlaceGraph::new(&nodes, &edges), &room_of);
    values.put("network_edits", count(edits));
}

/// Surfaces by the rooms that they truly bound, against the spaces that they were given to.
fn put_division(drive: &Drive, mapping: &Mapping, (network, truth): (&Network, &Truth), values: &mut Values) {
    let stored = mapping.mapper.mfis().surfaces().iter();
    let pieces = stored.filter_map(|stored| {
        let seen = mapping.reports.get(stored.step)?.view.surfaces.get(stored.index_in_view)?;
        let from = drive.looks.get(*mapping.look_of_report.get(stored.step)?)?.world_from_robot;
        let middle = from * seen.segment.midpoint();
        let room =
            room_at(&truth.rooms, middle + (from.position - middle).normalize_or_zero() * BEFORE_WALL)?;
        let asr = network.lasting(network.asr_of(stored.id)?).0;
        Some(Labelled { room: number(room), asr, size: seen.length() })
    });
    if let Some(division) = score_division(&pieces.collect::<Vec<_>>()) {
        values.put("purity", division.purity * 100.0);
        values.put("room_recall", division.recall * 100.0);
        values.put("room_precision", division.precision * 100.0);
        values.put("room_f1", division.f1);
        values.put("rand", division.adjusted_rand);
    }
}

#[allow(clippy::cast_precision_loss, reason = "nobody counts to 2^53")]
fn put_rate(hits: &str, runs: &str, rate: Rate, values: &mut Values) {
    values.put(hits, rate.hits as f64);
    values.put(runs, rate.runs as f64);
}

#[allow(clippy::cast_possible_truncation, reason = "a building has a few dozen rooms")]
fn number(room: usize) -> u32 {
    room as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missed_exit_is_no_false_closure() {
        let visit = |(room, asr)| Visit { room, asr };
        // The second room is taken for more of the first one; the fourth for the first one come back to.
        let visits = [(0, 0), (1, 0), (2, 1), (3, 0)].map(visit);
        let score = score_loops(&through_exits(&visits));
        assert_eq!(score.false_closures, Rate { hits: 1, runs: 3 });
    }

    #[test]
    fn a_visit_is_of_the_space_that_most_of_its_views_were_taken_in() {
        let asrs = [2, 1, 1, 2, 2].map(AsrId);
        assert_eq!(most_frequent(&asrs), AsrId(2));
        assert_eq!(most_frequent(&asrs[..4]), AsrId(1));
    }
}
