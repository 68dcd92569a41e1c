// The keyboard: STOP before everything else.
import type { KeyChange } from '../drive/inputs.ts';

export interface Keys {
  stop(): void;
  /** A key is pressed, repeated or released. True: this page drives by it, and the key has no other meaning. */
  driveKey(code: string, change: KeyChange): boolean;
  /** The keys that are held may be released without a word. */
  letGo(): void;
  /** What other keys do, by their character, each time they are pressed. */
  pressed: Partial<Record<string, () => void>>;
  /** The same for keys that also act again and again while they are held. */
  held: Partial<Record<string, () => void>>;
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
      keys.held[event.key]?.();
      if (!event.repeat) keys.pressed[event.key]?.();
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
