import type { Player } from './player';

/**
 * Shows the run to one mapper more, or to one less as long as one stays, and returns all that are left: a
 * drive goes on where it is, a log is mapped again. What the page last heard of may be older than the click
 * before this one, so the mappers are those that the run has.
 */
export function toggleMapper(player: Player, name: string): string[] {
  const before = mappersOf(player);
  const others = before.filter((mapper) => mapper !== name);
  const mappers = others.length < before.length ? others : [...before, name];
  if (mappers.length === 0) return before;
  remap(player, mappers);
  return mappers;
}

/** Puts the mapper first by whose memory the robot is to go home; a way home that it is on or made is undone. */
export function trust(player: Player, mapper: string): void {
  const laboratory = player.laboratory;
  if (!laboratory || player.resuming) return;
  while (laboratory.status().homing && laboratory.undo());
  remap(player, [mapper, ...mappersOf(player).filter((other) => other !== mapper)]);
}

function mappersOf({ laboratory }: Player): string[] {
  return laboratory?.status().memories.map(({ mapper }) => mapper) ?? [];
}

function remap(player: Player, mappers: string[]): void {
  player.laboratory?.remap(mappers);
  player.touch();
  if (player.source === 'log') player.play(true);
  else player.refresh();
}
