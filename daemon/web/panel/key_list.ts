// The list of the page's keys.
import { h } from './dom.ts';

const kKeys: [key: string, meaning: string][] = [
  ['space, esc', 'STOP'],
  ['r', 'start, or continue a paused run; asks for confirmation, or where the robot stands'],
  ['p', 'pause: stands still on the path, armed'],
  ['h', 'hold: ends the run or the drive and disarms'],
  ['m', 'drive by hand: takes the wheel; asks for confirmation'],
  ['arrows; w, a, s, d', 'while this page drives: forwards, left, backwards, right, as long as they are held'],
  ['1, 2, 3, 4', 'view: chase, top, free, map'],
  ['c', 'next view'],
  ['[, ]', 'step through a recording'],
  ['?', 'this list'],
  ['tab, arrows', 'from control to control; between the tabs'],
];

export function keyList(): HTMLElement {
  const list = h('dl', { class: 'keys' });
  for (const [key, meaning] of kKeys) list.append(h('dt', {}, h('kbd', {}, key)), h('dd', {}, meaning));
  return h('div', { tabindex: '0' }, list);
}
