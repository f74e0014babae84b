import type { Followed } from '../wasm/cogmap_wasm';
import type { Player } from './player';

/** Sends the robot to the place that is seen at a point of the view of the world. */
export function reach(player: Player, x: number, y: number): void {
  if (player.resuming || !player.laboratory?.reach(x, y)) return;
  player.touch();
  player.play(true);
}

/** Sends the robot along a line in the view of the world; what is answered says what becomes of it. */
export function follow(player: Player, line: Float64Array): Followed | undefined {
  if (player.resuming) return undefined;
  const followed = player.laboratory?.follow(line);
  if (followed?.kind !== 'going') return followed;
  player.touch();
  player.play(true);
  return followed;
}
