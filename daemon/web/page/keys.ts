// The keyboard: STOP before everything else; and the list of the keys.
import type { KeyChange } from '../drive/inputs.ts';
import { h, typing } from '../panel/dom.ts';

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

/** Whether `target` uses letters and arrows itself: a list. */
const chooses = (target: EventTarget | null): boolean => target instanceof HTMLSelectElement;

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
      // The space bar stops: the enter key checks a box.
      if (event.key === 'Enter' && event.target instanceof HTMLInputElement && event.target.type === 'checkbox') {
        event.preventDefault();
        event.target.click();
      }
      if (event.ctrlKey || event.metaKey || event.altKey || typing(event.target) || chooses(event.target)) return;
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

const kKeys: [key: string, meaning: string][] = [
  ['space, esc', 'STOP'],
  ['r', 'start, or resume a paused run; asks for confirmation, or where the robot stands'],
  ['p', 'pause: stands still on the path, motors on'],
  ['h', 'end the run or the drive: motors off'],
  ['m', 'mark this moment, in the recording that is made or shown'],
  ['t', 'drive by hand: takes the lease; asks for confirmation'],
  ['arrows; w, a, s, d', 'while this page drives: forwards, left, backwards, right, as long as they are held'],
  ['1, 2, 3, 4', 'Drive, Plan, Analyse, Set up'],
  ['c', 'next camera: chase, top, free, map'],
  ['[, ]', 'step through a recording'],
  ['?', 'this list'],
  ['tab, arrows', 'from control to control; between the tabs of a view'],
  ['enter', 'presses a button, checks a box'],
];

export function keyList(): HTMLElement {
  const list = h('dl', { class: 'keys' });
  for (const [key, meaning] of kKeys) list.append(h('dt', {}, h('kbd', {}, key)), h('dd', {}, meaning));
  return h('div', { tabindex: '0' }, list);
}
