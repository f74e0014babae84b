import type { Document } from './document.svelte';
import type { Drawing } from './drawing.svelte';
import type { Point } from './geometry';
import { GRID } from './snapping';
import { KEYS, TOOLS } from './tools';

const ARROWS: Record<string, Point> = { ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] };
/** Steps with Shift and with Alt, metres. */
const [FAR, FINE] = [1, 0.01];

/** What a key on the sheet does; `false` if it is none of the sheet's. */
export function onSheet(event: KeyboardEvent, drawing: Drawing, document: Document): boolean {
  const way = ARROWS[event.key];
  if (way) {
    const step = event.shiftKey ? FAR : event.altKey ? FINE : GRID;
    drawing.step([way[0] * step, way[1] * step], step);
    return true;
  }
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  switch (event.key) {
    case 'Enter':
      drawing.enter();
      return true;
    case 'Delete':
    case 'Backspace':
      drawing.letGo();
      if (!drawing.takeBack()) document.remove();
      return true;
    default:
      return choose(event, drawing);
  }
}

function choose(event: KeyboardEvent, drawing: Drawing): boolean {
  const key = event.key.toLowerCase();
  const tool = TOOLS.find((tool) => KEYS[tool] === key);
  if (tool) drawing.choose(tool);
  else if (key === 'g') drawing.toggleSnapping();
  else return false;
  return true;
}

/** What a key does anywhere in the editor; `false` if it does nothing. */
export function anywhere(event: KeyboardEvent, drawing: Drawing, document: Document): boolean {
  if (event.key === 'Escape') return drawing.abandon() || true;
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return false;
  drawing.letGo();
  switch (event.key.toLowerCase()) {
    case 'z':
      if (event.shiftKey) document.redo();
      else if (!drawing.takeBack()) document.undo();
      return true;
    case 'y':
      document.redo();
      return true;
    case 'd':
      document.duplicate();
      return true;
    default:
      return false;
  }
}
