// One run of the list, with its actions.
import { bytes, kUnknown } from '../state/format.ts';
import { kRunColumns, reportOf, titleOf, type RunKey, type RunEntry, type RunFile, type RunNote } from '../state/runs.ts';
import { button, deleteButton, h } from './dom.ts';

export interface RunActions {
  replay(file: RunFile, run: RunEntry): void;
  report(run: RunEntry): void;
  edit(run: RunEntry): void;
  remove(run: RunEntry): void;
  choose(run: RunEntry, on: boolean): void;
}

const kComparison = /^compare-(.+)\.html$/;

export function runRow(run: RunEntry, chosen: boolean, actions: RunActions): HTMLTableRowElement {
  const box = h('input', { type: 'checkbox', 'aria-label': `Compare ${titleOf(run)}` });
  box.checked = chosen;
  box.disabled = run.active;
  box.addEventListener('change', () => {
    actions.choose(run, box.checked);
  });
  const row = h(
    'tr',
    { 'data-run': run.run },
    h('td', { class: 'run-box' }, box),
    h('td', { class: 'run-what' }, ...about(run)),
    ...(Object.keys(kRunColumns) as RunKey[]).slice(1).map((key) => cell(key, run)),
    h('td', {}, h('div', { class: 'run-files' }, ...deeds(run, actions), ...files(run))),
  );
  if (run.active) row.classList.add('active');
  return row;
}

function cell(key: RunKey, run: RunEntry): HTMLElement {
  const { of, text } = kRunColumns[key];
  const shown = text === undefined ? String(of(run)) : text(run);
  const td = h('td', { class: `run-${key}${typeof of(run) === 'number' ? ' figure' : ''}` }, shown.startsWith(kUnknown) ? kUnknown : shown);
  if (key === 'outcome') {
    td.dataset.outcome = run.active ? '' : (run.result?.outcome ?? '');
    td.title = run.result?.cause ?? '';
  }
  return td;
}

function about(run: RunEntry): HTMLElement[] {
  const all = [h('span', { class: 'run-title' }, titleOf(run))];
  const line = (name: string, text: string): void => {
    if (text !== '') all.push(h('span', { class: name }, text));
  };
  for (const tag of run.tags.split(' ')) line('run-tag', tag);
  if (run.keep) line('run-tag', 'kept');
  if (run.name !== '') line('run-id', run.run);
  line('run-note', run.note);
  line('run-bad', run.note_error);
  return all;
}

/** Of a button that commands the daemon; disabled if this page may not command, or always if `fixed`. */
const deed = (name: string, label: string, fixed: boolean): Record<string, string> => ({ class: `link run-deed ${name}`, 'aria-label': label, 'data-fixed': String(fixed) });

function deeds(run: RunEntry, actions: RunActions): HTMLElement[] {
  const title = titleOf(run);
  const recording = run.files.find(({ name }) => name === 'run.mcap');
  const report = reportOf(run);
  const all: HTMLElement[] = [];
  if (report !== undefined) all.push(h('a', { class: 'run-report', href: report.url, target: '_blank', rel: 'noopener', 'aria-label': `Report of ${title}` }, 'report'));
  else if (recording !== undefined) all.push(button(deed('run-make', `Make the report of ${title}`, run.active), 'make report', () => { actions.report(run); }));
  if (recording !== undefined) all.push(button({ class: 'link', 'aria-label': `Replay ${title}` }, 'replay', () => { actions.replay(recording, run); }));
  for (const { name, url } of run.files) {
    const other = kComparison.exec(name)?.[1];
    if (other !== undefined) all.push(h('a', { href: url, target: '_blank', rel: 'noopener', title: `with ${other}` }, 'comparison'));
  }
  return [
    ...all,
    button(deed('run-edit', `Name and note of ${title}`, false), 'edit', () => { actions.edit(run); }),
    deleteButton(deed('run-delete', `Delete ${title}`, run.active || recording === undefined), () => { actions.remove(run); }),
  ];
}

/** Links to download every file, and all in one archive. */
function files(run: RunEntry): HTMLElement[] {
  const links = run.files
    .filter(({ kind }) => kind !== 'note')
    .map(({ name, url, bytes: size }) => h('a', { href: url, download: '', title: bytes(size) }, name));
  const count = links.length;
  if (count === 0) return [];
  links.push(h('a', { class: 'run-zip', href: `/runs/${run.run}.zip`, download: '', 'aria-label': `All files of ${titleOf(run)} as a ZIP archive` }, 'all (zip)'));
  return [h('details', { class: 'run-more' }, h('summary', {}, count === 1 ? '1 file' : `${count} files`), h('div', { class: 'run-links' }, ...links))];
}

/** The form that replaces a row. */
export function noteForm(run: RunEntry, save: (note: RunNote) => void, cancel: () => void): HTMLTableRowElement {
  const name = h('input', { type: 'text', name: 'run-name', maxlength: '80', value: run.name });
  const tags = h('input', { type: 'text', name: 'run-tags', maxlength: '200', value: run.tags, placeholder: 'words' });
  const note = h('textarea', { name: 'run-note', rows: '2', maxlength: '2000' }, run.note);
  const keep = h('input', { type: 'checkbox', name: 'run-keep' });
  keep.checked = run.keep;
  const form = h(
    'form',
    { class: 'run-form', 'aria-label': `Name and note of ${titleOf(run)}` },
    h('label', {}, 'name ', name),
    h('label', {}, 'tags ', tags),
    h('label', {}, keep, ' keep'),
    h('label', {}, 'note ', note),
    h('button', { type: 'submit', class: 'control run-save' }, 'Save'),
    button({ class: 'control' }, 'Cancel', cancel),
  );
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    save({ run: run.run, name: name.value.trim(), tags: tags.value.trim().replace(/\s+/g, ' '), note: note.value.trim(), keep: keep.checked });
  });
  return h('tr', { class: 'run-edited' }, h('td', { colspan: String(Object.keys(kRunColumns).length + 2) }, form));
}
