// The page's address: #VIEW, #VIEW/TAB, and the run that is replayed: #analyse&replay=RUN.

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
