// One finding of an examination, with its remedy.
import type { Finding } from '../state/doctor.ts';
import { h } from './dom.ts';

export function findingRow({ severity, name, seen, fix }: Finding): HTMLElement {
  const about = h('div', { class: 'finding-about' }, h('p', {}, seen));
  if (fix !== '') about.append(h('p', { class: 'finding-fix' }, `To do: ${fix}`));
  return h('li', { class: 'finding', 'data-severity': severity, 'data-name': name }, h('span', { class: 'finding-severity' }, severity), h('strong', {}, name), about);
}
