// The STOP button: always visible, acts on press, shows the result.
import { fixed } from '../state/format.ts';
import type { StopView } from '../state/stop.ts';
import { h, icon, setAttribute, setText, typing } from './dom.ts';

const kClickAfterPress_ms = 3000;

export class StopPanel {
  readonly element: HTMLButtonElement;
  private readonly line = h('span', { class: 'stop-line' });

  /** `keys`: names of the keys that do the same now; empty: none. */
  constructor(pressed: () => void, private readonly keys = stopKeys, text = 'STOP') {
    this.element = h('button', { class: 'stop', type: 'button', 'data-state': 'ready' });
    const word = h('span', { class: 'stop-word' }, icon('stop'), text);
    this.element.append(word, this.line);
    this.line.setAttribute('role', 'status');
    this.line.setAttribute('aria-live', 'assertive');
    if (keys() !== '') this.element.setAttribute('aria-keyshortcuts', 'Space Escape');
    // Acts on press, not on release. The click that follows belongs to the same press; a click
    // without a pointer comes from the enter key or from assistive technology.
    let pointer_ms = -Infinity;
    this.element.addEventListener('pointerdown', (event) => {
      pointer_ms = event.timeStamp;
      pressed();
    });
    this.element.addEventListener('click', (event) => {
      if (event.detail === 0 || event.timeStamp - pointer_ms > kClickAfterPress_ms) pressed();
    });
  }

  show(view: StopView): void {
    setAttribute(this.element, 'data-state', view.kind);
    setText(this.line, describe(view, this.keys()));
  }
}

/** The keys that press STOP: none on a touch screen; not the space bar while a text is typed. */
const stopKeys = (): string => (matchMedia('(any-hover: none)').matches ? '' : typing(document.activeElement) ? 'esc' : 'space or esc');

/** One short line that fits the button. */
export function describe(view: StopView, keys: string): string {
  switch (view.kind) {
    case 'ready':
      return keys;
    case 'pending':
      return 'sent\u2026';
    case 'not_acknowledged':
      return view.waiting ? 'not acknowledged \u00b7 no link' : 'not acknowledged';
    case 'stopped': {
      const by = view.by === '' || view.took_ms !== null ? '' : ` \u00b7 ${view.by}`;
      return view.took_ms === null ? `stopped${by}` : `robot stopped in ${fixed(view.took_ms, view.took_ms < 100 ? 1 : 0)} ms`;
    }
  }
}
