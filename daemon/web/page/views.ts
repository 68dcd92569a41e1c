// The four views of the page: one is shown, its name stands in the address (#VIEW, #VIEW/TAB, and the run that is replayed:
// #analyse&replay=RUN), and a row of links leads to each.
import { h, setAttribute } from '../panel/dom.ts';
import type { Tabs } from '../panel/tabs.ts';

export const kViews = ['drive', 'plan', 'analyse', 'setup'] as const;
export type ViewName = (typeof kViews)[number];

export interface Address {
  view: ViewName;
  /** Part of the view; empty: as it was. */
  tab: string;
  /** Everything else, which stays as it is. */
  others: [name: string, value: string][];
}

const isView = (name: string): name is ViewName => (kViews as readonly string[]).includes(name);

export function parseAddress(hash: string): Address {
  const parts = [...new URLSearchParams(hash.replace(/^#/, ''))];
  const at = parts.findIndex(([name]) => isView(name.split('/')[0] ?? ''));
  const [view = '', tab = ''] = parts[at]?.[0].split('/') ?? [];
  const others = parts.filter((_, i) => i !== at);
  // A report leads to the replay of its run.
  const first = others.some(([name]) => name === 'replay') ? 'analyse' : 'drive';
  return { view: isView(view) ? view : first, tab, others };
}

export function formatAddress({ view, tab, others }: Address): string {
  const rest = others.map(([name, value]) => `&${encodeURIComponent(name)}=${encodeURIComponent(value)}`);
  return `#${view}${tab === '' ? '' : `/${tab}`}${rest.join('')}`;
}

/** The value of one of the other parts. */
export const valueIn = ({ others }: Address, name: string): string | undefined => others.find(([each]) => each === name)?.[1];

/** What the row says of each view, in its order; the keys 1 to 4 lead there. */
const kTitles: Record<ViewName, [title: string, about: string]> = {
  drive: ['Drive', 'the robot now: start, stop, watch, drive by hand'],
  plan: ['Plan', 'courses, robot and set-up; draw a course'],
  analyse: ['Analyse', 'recorded runs: reports, replay, signals'],
  setup: ['Set up', 'doctor, identification, parameters, link'],
};

export class Views {
  readonly element = h('nav', { class: 'views', 'aria-label': 'Views' });
  private readonly links = new Map<ViewName, HTMLAnchorElement>();

  /** `tabs`: of the views that have some. `changed`: another view is shown. */
  constructor(
    private readonly tabs: Partial<Record<ViewName, Tabs>>,
    private readonly changed: () => void,
  ) {
    kViews.forEach((view, i) => {
      const [title, about] = kTitles[view];
      const link = h('a', { id: `view-${view}`, title: `${about} (${i + 1})`, 'aria-keyshortcuts': String(i + 1) }, title);
      this.links.set(view, link);
      this.element.append(link);
    });
    for (const [view, each] of Object.entries(tabs)) {
      each.chosen = () => {
        if (this.shown === view) this.write();
      };
    }
    document.body.dataset.view = this.shown;
    window.addEventListener('hashchange', () => { this.read(); });
    this.read();
  }

  /** The view that is shown. */
  get shown(): ViewName {
    return parseAddress(location.hash).view;
  }

  go(view: ViewName, tab = ''): void {
    location.hash = formatAddress({ ...parseAddress(location.hash), view, tab });
    this.read();
  }

  /** Keeps a value in the address; undefined: it is there no more. */
  keep(name: string, value: string | undefined): void {
    const address = parseAddress(location.hash);
    const others = address.others.filter(([each]) => each !== name);
    if (value !== undefined) others.push([name, value]);
    history.replaceState(null, '', formatAddress({ ...address, others }));
    this.write();
  }

  /** Shows what the address says. */
  private read(): void {
    const { view, tab } = parseAddress(location.hash);
    if (tab !== '') this.tabs[view]?.select(tab);
    const other = document.body.dataset.view !== view;
    document.body.dataset.view = view;
    this.write();
    if (!other) return;
    scrollTo(0, 0);
    this.changed();
  }

  /** Completes the address, without another step of the browser's history. */
  private write(): void {
    const address = parseAddress(location.hash);
    const { view } = address;
    history.replaceState(null, '', formatAddress({ ...address, tab: this.tabs[view]?.selected ?? '' }));
    for (const [name, link] of this.links) {
      setAttribute(link, 'href', formatAddress({ ...address, view: name, tab: '' }));
      if (name === view) setAttribute(link, 'aria-current', 'page');
      else link.removeAttribute('aria-current');
    }
  }
}
