// Events, newest first: with the wall-clock time if it is known, filtered by level and by words.
import { clock, hasWords, wallClock } from '../state/format.ts';
import type { Event } from '../state/messages.ts';
import { kEvents, type Store } from '../state/store.ts';
import { h } from './dom.ts';

const kLevels = ['info', 'warning', 'error'];

export class EventLog {
  readonly element = h('div', { class: 'events', tabindex: '0' });
  private readonly list = h('ol', { class: 'event-list' });
  private readonly level = h('select', { 'aria-label': 'Level of events' });
  private readonly search = h('input', { type: 'search', placeholder: 'search', 'aria-label': 'Search events' });
  private readonly none = h('p', { class: 'empty', hidden: '' }, 'No event matches.');
  private shown: Event[] = [];
  private source: Store | undefined;
  private began_unix_s: number | undefined;

  constructor() {
    ['all events', 'warnings, errors', 'errors'].forEach((text, i) => {
      this.level.append(h('option', { value: String(i) }, text));
    });
    for (const element of [this.level, this.search]) element.addEventListener('input', () => { this.narrow(); });
    this.element.append(h('div', { class: 'tab-bar' }, this.level, this.search), h('div', { role: 'log' }, this.list), this.none);
  }

  /** `began_unix_s`: Unix time of t_s = 0; undefined if not known or if the time is virtual. */
  show(store: Store, began_unix_s: number | undefined): void {
    if (store !== this.source || store.events.length === 0 || began_unix_s !== this.began_unix_s) {
      this.source = store;
      this.began_unix_s = began_unix_s;
      this.shown = [];
      this.list.replaceChildren();
    }
    const last = this.shown.at(-1);
    const from = last === undefined ? 0 : store.events.lastIndexOf(last) + 1;
    if (from === store.events.length) return;
    for (const event of store.events.slice(from)) this.add(event);
    while (this.list.children.length > kEvents) this.list.lastElementChild?.remove();
    this.shown = store.events.slice(-1);
    this.narrow();
  }

  /** Adds an event; one like the newest before it takes its place, and counts. */
  private add(event: Event): void {
    const next = row(event, this.began_unix_s);
    const before = this.list.firstElementChild;
    if (before instanceof HTMLElement && before.dataset.like === next.dataset.like) {
      const times = Number(before.dataset.times ?? 1) + 1;
      next.dataset.times = String(times);
      next.querySelector('.event-text')?.append(h('span', { class: 'event-times' }, `\u00d7 ${times}`));
      before.remove();
    }
    this.list.prepend(next);
  }

  private narrow(): void {
    let any = this.list.children.length === 0;
    for (const element of this.list.children) {
      if (!(element instanceof HTMLElement)) continue;
      element.hidden = kLevels.indexOf(element.dataset.level ?? '') < Number(this.level.value) || !hasWords(element.textContent, this.search.value);
      any ||= !element.hidden;
    }
    this.none.hidden = any;
  }
}

function row(event: Event, began_unix_s: number | undefined): HTMLElement {
  const what = [event.cause, event.fix].filter((text) => text !== '').join(' \u2014 ');
  const since = clock(event.t_s);
  const time = began_unix_s === undefined ? since : wallClock(began_unix_s + event.t_s);
  return h(
    'li',
    // Events that differ only in figures are alike.
    { class: 'event', 'data-level': event.level, 'data-kind': event.kind, 'data-like': `${event.level} ${event.kind} ${event.text.replace(/\d+(\.\d+)?/g, '#')}` },
    h('time', { title: `${since} since the start of tp100d` }, time),
    h('span', { class: 'event-kind' }, event.kind),
    h('span', { class: 'event-text' }, event.text, ...(what === '' ? [] : [h('span', { class: 'event-cause' }, what)])),
  );
}
