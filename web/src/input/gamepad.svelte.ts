import type { Stick } from '../state/stick';

/** What a button of a gamepad does. */
export type PadAction = 'home' | 'stop' | 'toggle';

/** The places of buttons on a standard gamepad (W3C Gamepad, §7). */
const ACTIONS: Record<number, PadAction> = { 0: 'home', 1: 'stop', 9: 'toggle' };
const CROSS = { up: 12, down: 13, left: 14, right: 15 };

/** The gamepad that was touched last, and what is done with it. */
export class GamepadInput {
  /** Whether one was found. Browsers show a gamepad only once one of its buttons was pressed. */
  found = $state(false);
  private index: number | undefined;
  private down = new Set<number>();
  /** Whether its stick is what drives. */
  private steering = false;

  constructor(
    private readonly stick: Stick,
    private readonly act: (action: PadAction) => void,
  ) {}

  /** Watches for gamepads until the returned function is called. */
  watch(): () => void {
    const closing = new AbortController();
    const { signal } = closing;
    window.addEventListener('gamepadconnected', ({ gamepad }) => this.take(gamepad.index, signal), { signal });
    window.addEventListener('gamepaddisconnected', ({ gamepad }) => this.lose(gamepad.index), { signal });
    window.addEventListener('blur', () => this.letGo(), { signal });
    return () => closing.abort();
  }

  private take(index: number, signal: AbortSignal): void {
    const watching = this.index !== undefined;
    this.index = index;
    this.found = true;
    // Buttons that are down as it is found are not pressed now.
    this.down = pressed(navigator.getGamepads()[index]);
    if (!watching) this.look(signal);
  }

  private lose(index: number): void {
    if (index !== this.index) return;
    this.index = undefined;
    this.found = false;
    this.letGo();
  }

  /** Gamepads tell nothing by themselves: they have to be looked at. */
  private look(signal: AbortSignal): void {
    if (this.index === undefined || signal.aborted) return;
    const pad = navigator.getGamepads()[this.index];
    if (pad && document.hasFocus()) this.read(pad);
    requestAnimationFrame(() => this.look(signal));
  }

  private read(pad: Gamepad): void {
    const down = pressed(pad);
    const cross = (plus: number, minus: number) => Number(down.has(plus)) - Number(down.has(minus));
    const ahead = cross(CROSS.up, CROSS.down) || -(pad.axes[1] ?? 0);
    const left = cross(CROSS.left, CROSS.right) || -(pad.axes[0] ?? 0);
    const pushed = this.stick.isPushed(ahead, left);
    if (pushed || this.steering) this.stick.point(ahead, left);
    this.steering = pushed;
    for (const [button, action] of Object.entries(ACTIONS)) {
      if (down.has(Number(button)) && !this.down.has(Number(button))) this.act(action);
    }
    this.down = down;
  }

  private letGo(): void {
    if (this.steering) this.stick.release();
    this.steering = false;
  }
}

function pressed(pad: Gamepad | null | undefined): Set<number> {
  return new Set(pad?.buttons.flatMap((button, index) => (button.pressed ? [index] : [])));
}
