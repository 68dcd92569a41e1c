// The robot of this page, named in the header and in the browser's tab.
import type { Store } from '../state/store.ts';
import { h, icon, setAttribute, setText } from './dom.ts';

export class Identity {
  private readonly badge = h('span', { class: 'badge' });
  private readonly setting = h('span', { class: 'setting' });
  private readonly robots = h('a', { class: 'robots-link', href: 'robots.html', 'aria-label': 'All robots', title: 'All robots' }, icon('grid'));
  readonly element: HTMLElement;

  /** `tools`: beside the name. */
  constructor(...tools: HTMLElement[]) {
    this.element = h('div', { class: 'identity' }, this.robots, h('h1', {}, 'TP100'), this.setting, this.badge, ...tools);
  }

  /** `metadata`: sent by the daemon when this page connected. */
  show(store: Store, metadata: { robot?: string; setup?: string }): void {
    const state = store.get('/state');
    const parts = [state?.robot ?? metadata.robot, state?.setup ?? metadata.setup].filter(Boolean);
    setText(this.setting, parts.join(' \u00b7 '));
    const title = state === undefined ? 'TP100' : `${state.run} \u00b7 TP100`;
    if (document.title !== title) document.title = title;
    const kind = store.get('/link')?.kind;
    setText(this.badge, kind === 'simulated' ? 'simulated inside the board' : (kind ?? ''));
    setAttribute(this.badge, 'data-kind', kind ?? '');
  }
}
