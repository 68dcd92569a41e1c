// Events, newest first.
import { clock } from '../state/format.ts';
import type { Event } from '../state/messages.ts';
import { kEvents, type Store } from '../state/store.ts';
import { h } from './dom.ts';

export class EventLog {
  readonly element = h('div', { class: 'events', tabindex: '0' });
  private readonly list = h('ol', { class: 'event-list', role: 'log' });
  private shown: Event[] = [];
  private source: Store | undefined;

  constructor() {
    this.element.append(this.list);
  }

  show(store: Store): void {
    if (store !== this.source || store.events.length === 0) {
      this.source = store;
      this.shown = [];
      this.list.replaceChildren();
    }
    const last = this.shown.at(-1);
    const from = last === undefined ? 0 : store.events.lastIndexOf(last) + 1;
    for (const event of store.events.slice(from)) this.list.prepend(row(event));
    while (this.list.children.length > kEvents) this.list.lastElementChild?.remove();
    this.shown = store.events.slice(-1);
  }
}

function row(event: Event): HTMLElement {
  const what = [event.cause, event.fix].filter((text) => text !== '').join(' \u2014 ');
  return h(
    'li',
    { class: 'event', 'data-level': event.level, 'data-kind': event.kind },
    h('time', {}, clock(event.t_s)),
    h('span', { class: 'event-kind' }, event.kind),
    h('span', { class: 'event-text' }, event.text, ...(what === '' ? [] : [h('span', { class: 'event-cause' }, what)])),
  );
}
