// Below the header, in all views: the most severe current problem with its remedy, and all others on request.
import { fixed } from '../state/format.ts';
import type { LinkPace } from '../state/link_pace.ts';
import type { Store } from '../state/store.ts';
import { button, h, icon, setAttribute, setText } from './dom.ts';
import { slowText } from './status_bar.ts';

const kAnswer_ms = 6000;

interface Problem {
  level: 'bad' | 'warn';
  what: string;
  todo: string;
}

export class Notice {
  readonly element = h('div', { class: 'notice', role: 'status', 'data-level': 'none' });
  private readonly list = h('ul', { id: 'notice-list' });
  private readonly more = button({ id: 'notice-more', 'aria-controls': 'notice-list', 'aria-expanded': 'false' }, '', () => {
    this.open = !this.open;
    this.render();
  });
  private readonly close = button({ id: 'notice-close', 'aria-label': 'Close this notice' }, icon('close'), () => {
    this.closed = text(this.all);
    this.answerUntil_ms = 0;
    this.render();
  });
  private answer = '';
  private answerUntil_ms = 0;
  private all: Problem[] = [];
  private open = false;
  /** The text that was closed; another text opens the notice again. */
  private closed = '';
  private shown = '';

  constructor() {
    this.element.append(this.list, this.more, this.close);
  }

  /** The daemon's answer to a request of this page; shown for a few seconds. */
  say(text: string, now_ms: number): void {
    this.answer = text;
    this.answerUntil_ms = now_ms + kAnswer_ms;
    this.closed = '';
  }

  /** `replaying`: the view shows a recording, which needs no robot. */
  show(store: Store, connected: boolean, retryIn_s: number, now_ms: number, replaying: boolean, pace: LinkPace): void {
    this.all = problems(store, connected, retryIn_s, replaying);
    if (connected && pace.slow) this.all.push({ level: 'warn', what: 'Your connection to the daemon is slow', todo: slowText(pace) });
    if (connected && now_ms < this.answerUntil_ms) this.all.unshift({ level: 'warn', what: this.answer, todo: '' });
    this.render();
  }

  private render(): void {
    if (this.closed !== '' && this.closed !== text(this.all)) this.closed = '';
    const visible = this.closed === '' ? this.all : [];
    const rows = this.open ? visible : visible.slice(0, 1);
    const key = text(rows);
    if (key !== this.shown) {
      this.shown = key;
      this.list.replaceChildren(...rows.map(({ what, todo }) => h('li', {}, h('strong', {}, what), ' ', h('span', {}, todo))));
    }
    setAttribute(this.element, 'data-level', rows[0]?.level ?? 'none');
    const others = visible.length - 1;
    this.more.hidden = others < 1;
    setText(this.more, this.open ? 'less' : `${others} more`);
    setAttribute(this.more, 'aria-expanded', String(this.open));
  }
}

const text = (all: Problem[]): string => JSON.stringify(all);

/** All current problems, the most severe first. */
function problems(store: Store, connected: boolean, retryIn_s: number, replaying: boolean): Problem[] {
  if (!connected) return [{ level: 'bad', what: 'No connection to tp100d', todo: retryIn_s > 0 ? 'trying again' : 'connecting' }];
  const state = store.get('/state');
  if (state === undefined) return [];
  const all: Problem[] = [];
  if (store.stale('/state')) all.push({ level: 'bad', what: 'The daemon is silent', todo: 'grey values are old' });
  if (state.session !== 'ready' && !replaying) {
    const link = store.get('/link');
    const port = link === undefined || link.port === '' ? 'No robot' : `No robot on ${link.port}`;
    // The headline has the port already; commands in a text stand between backticks.
    const note = (link?.note ?? '').replace(link?.port ? `${link.port}: ` : '', '').replaceAll('`', '');
    all.push({ level: 'warn', what: port, todo: state.session === 'closed' ? note : state.why_not_start });
  }
  // After a completed run, a fault explains why the next one cannot begin; the run did not fail.
  const level = state.run === 'finished' ? 'warn' : 'bad';
  for (const fault of state.faults) if (fault.name !== 'stop_requested') all.push({ level, what: fault.cause, todo: fault.fix });
  if (store.battery.low && !replaying)
    all.push({ level: 'warn', what: 'The battery is low', todo: `below ${fixed(store.battery.limit_v, 2)} V a run is aborted; charge it before the next one` });
  return all;
}
