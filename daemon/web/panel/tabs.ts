// The tabs of a view, with the usual keys: arrows select a tab, the selected one is shown.
import { button, h, setAttribute } from './dom.ts';

export interface Tab {
  id: string;
  title: string;
  element: HTMLElement;
  /** Called when the tab is selected, and periodically while it is shown. */
  show(): void;
}

export class Tabs {
  readonly element: HTMLElement;
  /** Called when another tab was selected. */
  chosen: () => void = () => undefined;
  private readonly buttons: HTMLButtonElement[];
  private current = 0;

  /** `name`: class of the element; `label`: for reading. */
  constructor(
    name: string,
    label: string,
    private readonly pages: Tab[],
  ) {
    const list = h('div', { class: 'tabs', role: 'tablist', 'aria-label': label });
    this.buttons = pages.map((page, i) => {
      const tab = button({ role: 'tab', id: `tab-${page.id}`, 'aria-controls': `page-${page.id}` }, page.title, () => { this.choose(i); });
      tab.addEventListener('keydown', (event) => {
        const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (step === undefined) return;
        this.choose((this.current + step + pages.length) % pages.length);
        this.buttons[this.current]?.focus();
      });
      return tab;
    });
    list.append(...this.buttons);
    this.element = h('section', { class: `tabbed ${name}`, 'aria-label': label }, list);
    for (const page of pages) {
      setAttribute(page.element, 'id', `page-${page.id}`);
      setAttribute(page.element, 'role', 'tabpanel');
      setAttribute(page.element, 'aria-labelledby', `tab-${page.id}`);
      page.element.classList.add('page');
      this.element.append(page.element);
    }
    this.mark(0);
  }

  show(): void {
    this.pages[this.current]?.show();
  }

  get selected(): string {
    return this.pages[this.current]?.id ?? '';
  }

  /** Without such a tab, nothing changes. */
  select(id: string): void {
    const index = this.pages.findIndex((page) => page.id === id);
    if (index >= 0) this.choose(index);
  }

  private choose(index: number): void {
    this.mark(index);
    this.show();
    this.chosen();
  }

  private mark(index: number): void {
    this.current = index;
    this.pages.forEach((page, i) => {
      const chosen = i === index;
      page.element.hidden = !chosen;
      const tab = this.buttons[i];
      if (tab === undefined) return;
      setAttribute(tab, 'aria-selected', String(chosen));
      tab.tabIndex = chosen ? 0 : -1;
    });
  }
}
