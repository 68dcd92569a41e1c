// The keyboard: STOP before everything else.
import type { KeyChange } from '../drive/inputs.ts';

export interface Keys {
  stop(): void;
  start(): void;
  hold(): void;
  /** Pauses a run. */
  pause(): void;
  /** Takes the wheel. */
  drive(): void;
  /** A key is pressed, repeated or released. True: this page drives by it, and the key has no other meaning. */
  driveKey(code: string, change: KeyChange): boolean;
  /** The keys that are held may be released without a word. */
  letGo(): void;
  camera(index: number): void;
  nextCamera(): void;
  /** Shows the list of keys. */
  keys(): void;
  /** Steps through a recording; does nothing while live. */
  step(direction: 1 | -1): void;
}

/** Whether `target` uses the space bar itself. */
function typing(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.matches('input:not([type=range]), select, textarea');
}

/** Browsers on macOS do not tell that a key is released while Cmd is held. */
const hidesReleases = (event: KeyboardEvent): boolean => event.metaKey || event.key === 'Meta';

export function listen(keys: Keys): void {
  // Before any element that might handle the key itself.
  window.addEventListener(
    'keydown',
    (event) => {
      if (event.key === 'Escape' || (event.code === 'Space' && !typing(event.target))) {
        event.preventDefault();
        if (!event.repeat) keys.stop();
        return;
      }
      if (hidesReleases(event)) keys.letGo();
      if (event.ctrlKey || event.metaKey || event.altKey || typing(event.target)) return;
      if (keys.driveKey(event.code, event.repeat ? 'repeated' : 'pressed')) {
        event.preventDefault();
        event.stopPropagation();
        return;
      }
      if (event.key === 'r' && !event.repeat) keys.start();
      else if (event.key === 'h' && !event.repeat) keys.hold();
      else if (event.key === 'p' && !event.repeat) keys.pause();
      else if (event.key === 'm' && !event.repeat) keys.drive();
      else if (event.key === 'c') keys.nextCamera();
      else if (event.key >= '1' && event.key <= '4') keys.camera(Number(event.key) - 1);
      else if (event.key === '?') keys.keys();
      else if (event.key === '[') keys.step(-1);
      else if (event.key === ']') keys.step(1);
    },
    { capture: true },
  );
  // The space bar must not also click the focused element.
  window.addEventListener(
    'keyup',
    (event) => {
      if (event.code === 'Space' && !typing(event.target)) event.preventDefault();
      if (hidesReleases(event)) keys.letGo();
      keys.driveKey(event.code, 'released');
    },
    { capture: true },
  );
}
