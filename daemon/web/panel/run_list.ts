// The daemon's recorded runs: to name, report, compare, replay and delete.
import { bytes } from '../state/format.ts';
import { arranged, courseOf, kRunColumns, runsTable, titleOf, type RunEntry, type RunFile, type RunKey, type RunNote, type RunsList } from '../state/runs.ts';
import { button, h, Message, saveText, setAttribute, setText } from './dom.ts';
import { noteForm, runRow, type RunActions } from './run_row.ts';
import { fetched, Listing, reason, type Call } from '../state/service.ts';

const kCompared = 2;

export class RunList {
  readonly element = h('div', { class: 'runs', tabindex: '0' });
  private readonly body = h('tbody');
  private readonly empty = h('p', { class: 'empty' });
  private readonly table: HTMLElement;
  private readonly room = h('span', { class: 'runs-room' });
  private readonly compareButton = button({ class: 'control', id: 'compare' }, 'Compare', () => {
    // In the order of the list: the newest is compared with the one before.
    const [run, other] = (this.list?.runs ?? []).filter(({ run }) => this.chosen.has(run));
    if (run !== undefined && other !== undefined)
      void this.make(`the comparison of ${titleOf(run)} with ${titleOf(other)}`, 'run_compare', { run: run.run, with: other.run });
  });
  /** What the daemon is making for another page. */
  private readonly busy = h('span', { class: 'runs-room' });
  private readonly message = new Message('runs-message');
  private readonly rows = new Map<string, { text: string; element: HTMLTableRowElement }>();
  private readonly chosen = new Set<string>();
  private readonly actions: RunActions;
  private readonly listing = new Listing<RunsList>('/api/runs', (list) => { this.build(list); }, () => {
    this.empty.hidden = !this.table.hidden;
    this.empty.textContent = 'The list of runs is not available now.';
  });
  private readonly search = h('input', { type: 'search', placeholder: 'search runs', 'aria-label': 'Search runs' });
  private readonly heads = new Map<RunKey, HTMLElement>();
  private order: { key: RunKey; down: boolean } = { key: 'recorded', down: true };
  private list: RunsList | undefined;
  private mayCommand = false;
  private replayed = '';
  private editing: string | undefined;
  /** What is being made for this page, and since when. */
  private making: { what: string; since_ms: number } | undefined;

  constructor(
    replay: (file: RunFile, run: RunEntry) => void,
    private readonly call: Call,
  ) {
    const head = (Object.keys(kRunColumns) as RunKey[]).map((key) => this.column(key));
    this.table = h('table', {}, h('thead', {}, h('tr', {}, h('td'), ...head, h('td'))), this.body);
    const save = button({ class: 'control', id: 'runs-csv', title: 'Save these runs as a table' }, 'CSV', () => { saveText('runs.csv', runsTable(this.arranged)); });
    this.search.addEventListener('input', () => { this.arrange(); });
    this.element.append(h('div', { class: 'tab-bar' }, this.room, this.search, save, this.compareButton, this.busy, this.message.element), this.table, this.empty);
    this.sort('recorded', true);
    this.table.hidden = true;
    this.actions = {
      replay,
      report: ({ run }) => { this.report(run); },
      edit: ({ run }) => { this.edit(run); },
      remove: ({ run }) => void this.change('run_delete', { run }),
      choose: ({ run }, on) => {
        if (on) this.chosen.add(run);
        else this.chosen.delete(run);
        this.enable();
      },
    };
  }

  /** Draws the tab's content; reloads the list from time to time. `replayed`: the run that this page replays. */
  show(mayCommand: boolean, replayed: string): void {
    this.mayCommand = mayCommand;
    this.replayed = replayed;
    this.enable();
    if (this.making !== undefined) this.message.say(`Making ${this.making.what} \u2026 ${((performance.now() - this.making.since_ms) / 1000).toFixed(0)} s`);
    this.listing.show();
  }

  /** The list has changed: reload it at once. */
  changed(): void {
    this.listing.reload();
  }

  report(run: string): void {
    const title = titleOf(this.list?.runs.find((each) => each.run === run) ?? { name: '', run });
    void this.make(`the report of ${title}`, 'run_report', { run });
  }

  /** With the run of the same course before it. */
  async compareWithBefore(run: string): Promise<void> {
    const runs = await fetched('/api/runs').then((text) => (JSON.parse(text) as RunsList).runs, () => []);
    const course = runs.filter((each) => each.run === run).map(courseOf)[0];
    const before = runs.filter((each) => courseOf(each) === course && each.run < run && !each.active).map((each) => each.run).sort().at(-1);
    if (before === undefined) this.message.say('There is no run of this course before it.', true);
    else await this.make(`the comparison of ${run} with ${before}`, 'run_compare', { run, with: before });
  }

  private enable(): void {
    const busy = this.making !== undefined || (this.list?.making ?? '') !== '';
    this.compareButton.disabled = !this.mayCommand || busy || this.chosen.size !== kCompared;
    this.compareButton.title = this.chosen.size === kCompared ? '' : 'Choose two runs';
    for (const button of this.body.querySelectorAll<HTMLButtonElement>('.run-deed')) {
      const run = button.closest('tr')?.dataset.run;
      const replayed = button.classList.contains('run-delete') && run === this.replayed;
      button.disabled = !this.mayCommand || button.dataset.fixed === 'true' || replayed || (busy && button.classList.contains('run-make'));
    }
  }

  private column(key: RunKey): HTMLElement {
    const head = h('th', { scope: 'col', class: `run-${key}` }, button({ title: 'Sort by this' }, kRunColumns[key].title, () => {
      this.sort(key, this.order.key === key ? !this.order.down : key === 'recorded');
    }));
    this.heads.set(key, head);
    return head;
  }

  private sort(key: RunKey, down: boolean): void {
    this.order = { key, down };
    for (const [each, head] of this.heads) setAttribute(head, 'aria-sort', each !== key ? 'none' : down ? 'descending' : 'ascending');
    this.arrange();
  }

  private get arranged(): RunEntry[] {
    return arranged(this.list?.runs ?? [], this.search.value, this.order.key, this.order.down);
  }

  /** Shows the runs that were searched for, in their order. */
  private arrange(): void {
    // Unchanged rows stay in the page, so that they keep the focus and their open parts.
    const rows = this.arranged.map((run) => this.row(run));
    for (const old of [...this.body.rows]) if (!rows.includes(old)) old.remove();
    rows.forEach((row, i) => { if (this.body.rows[i] !== row) this.body.insertBefore(row, this.body.rows[i] ?? null); });
    this.enable();
  }

  private build(list: RunsList): void {
    this.list = list;
    const { runs, directory } = list;
    const known = new Set(runs.map(({ run }) => run));
    for (const run of [...this.rows.keys()]) if (!known.has(run)) this.rows.delete(run);
    for (const run of [...this.chosen]) if (!known.has(run)) this.chosen.delete(run);
    this.table.hidden = runs.length === 0;
    this.empty.hidden = runs.length > 0;
    this.empty.textContent = directory
      ? `No runs in ${directory} yet. Press Record, or start tp100d with --record.`
      : 'Nothing is recorded: start tp100d with --record DIR.';
    setText(this.room, directory === '' ? '' : roomText(list));
    this.compareButton.hidden = runs.length < kCompared;
    setText(this.busy, list.making === '' || this.making !== undefined ? '' : `A report of ${list.making} is being made.`);
    this.arrange();
  }

  private row(run: RunEntry): HTMLTableRowElement {
    const text = JSON.stringify(run);
    const old = this.rows.get(run.run);
    if (old !== undefined && (old.text === text || this.editing === run.run)) return old.element;
    const element = runRow(run, this.chosen.has(run.run), this.actions);
    this.rows.set(run.run, { text, element });
    return element;
  }

  private edit(name: string): void {
    if (this.editing !== undefined) this.endEdit();
    const run = this.list?.runs.find((each) => each.run === name);
    const old = this.rows.get(name)?.element;
    if (run === undefined || old === undefined) return;
    const save = async (note: RunNote): Promise<void> => {
      if (await this.change('run_note', note)) this.endEdit();
    };
    const element = noteForm(run, (note) => void save(note), () => { this.endEdit(); });
    old.replaceWith(element);
    this.editing = name;
    this.rows.set(name, { text: '', element });
    element.querySelector('input')?.focus();
  }

  private endEdit(): void {
    const name = this.editing;
    this.editing = undefined;
    const run = this.list?.runs.find((each) => each.run === name);
    const old = name === undefined ? undefined : this.rows.get(name);
    if (run === undefined || old === undefined) return;
    this.rows.delete(run.run);
    old.element.replaceWith(this.row(run));
    this.listing.reload();
  }

  /** Asks the daemon; true: done. */
  private async change(service: string, request: object): Promise<boolean> {
    this.message.say('');
    try {
      await this.call(service, request);
      return true;
    } catch (error: unknown) {
      this.message.say(reason(error), true);
      return false;
    } finally {
      this.listing.reload();
    }
  }

  /** Lets the daemon make a page and opens it in a new tab; if the browser does not permit that, shows a link. */
  private async make(what: string, service: string, request: object): Promise<void> {
    this.making = { what, since_ms: performance.now() };
    this.message.say('');
    this.enable();
    try {
      const { url } = (await this.call(service, request)) as { url: string };
      const link = h('a', { href: url, target: '_blank', rel: 'noopener', id: 'made' }, `Open ${what}`);
      this.making = undefined;
      this.message.element.replaceChildren(link);
      window.open(url, '_blank', 'noopener');
    } catch (error: unknown) {
      this.making = undefined;
      this.message.say(`${what} is not made: ${reason(error)}`, true);
    } finally {
      this.listing.reload();
    }
  }

}

/** For example "12 runs, 340 MB of at most 1000 MB; 20 GB free". */
function roomText({ runs, bytes: used, quota_bytes, free_bytes }: RunsList): string {
  const count = runs.length === 1 ? '1 run' : `${runs.length} runs`;
  const most = quota_bytes > 0 ? ` of at most ${bytes(quota_bytes)}` : '';
  return `${count}, ${bytes(used)}${most} \u00b7 ${bytes(free_bytes)} free`;
}
