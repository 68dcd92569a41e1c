// The runs that the daemon has recorded, with their reports and files.
import { bytes } from '../state/format.ts';
import { h } from './dom.ts';

export interface RunFile {
  name: string;
  bytes: number;
  url: string;
  kind: string;
}

export interface RunEntry {
  run: string;
  modified_unix_s: number;
  bytes: number;
  active: boolean;
  files: RunFile[];
}

const kRefresh_ms = 5000;

export class RunList {
  readonly element = h('div', { class: 'runs', tabindex: '0' });
  private readonly body = h('tbody');
  private readonly empty = h('p', { class: 'empty' });
  private readonly table: HTMLElement;
  private next_ms = 0;
  private shown = '';

  constructor(
    private readonly open: (file: RunFile, run: RunEntry) => void,
    private readonly now: () => number = () => performance.now(),
  ) {
    const head = ['run', 'recorded', 'size', ''].map((title) => h('th', { scope: 'col' }, title));
    this.table = h('table', {}, h('thead', {}, h('tr', {}, ...head)), this.body);
    this.element.append(this.table, this.empty);
    this.table.hidden = true;
  }

  show(): void {
    if (this.now() < this.next_ms) return;
    this.next_ms = this.now() + kRefresh_ms;
    void this.load();
  }

  /** The list has changed: reload it at once. */
  changed(): void {
    this.next_ms = 0;
  }

  private async load(): Promise<void> {
    try {
      const response = await fetch('/api/runs', { cache: 'no-store' });
      if (!response.ok) throw new Error(response.statusText);
      const text = await response.text();
      if (text === this.shown) return;
      this.shown = text;
      const { runs, directory } = JSON.parse(text) as { runs: RunEntry[]; directory: string };
      this.body.replaceChildren(...runs.map((run) => this.row(run)));
      this.table.hidden = runs.length === 0;
      this.empty.hidden = runs.length > 0;
      this.empty.textContent = directory
        ? `No runs in ${directory} yet. Press Record, or start tp100d with --record.`
        : 'Nothing is recorded: start tp100d with --record DIR.';
    } catch {
      this.shown = '';
      this.empty.hidden = !this.table.hidden;
      this.empty.textContent = 'The list of runs is not available now.';
    }
  }

  private row(run: RunEntry): HTMLElement {
    const links = h('td', { class: 'run-files' });
    for (const file of run.files) {
      if (file.kind === 'recording') {
        const open = h('button', { type: 'button', class: 'link' }, 'replay');
        open.addEventListener('click', () => {
          this.open(file, run);
        });
        links.append(open);
      }
      const link = h('a', { href: file.url, title: `${file.name}, ${bytes(file.bytes)}` }, file.kind === 'other' ? file.name : file.kind);
      if (file.kind === 'report' || file.kind === 'figure') link.target = '_blank';
      else link.setAttribute('download', '');
      links.append(link);
    }
    return h(
      'tr',
      run.active ? { class: 'active' } : {},
      h('td', {}, run.run),
      h('td', {}, run.active ? 'recording' : new Date(1000 * run.modified_unix_s).toLocaleString()),
      h('td', { class: 'figure' }, bytes(run.bytes)),
      links,
    );
  }
}
