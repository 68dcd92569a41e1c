// Tabs below the view, with the usual keys: arrows select a tab, the selected one is shown.
import { button, h, setAttribute, setText } from './dom.ts';

export interface Page {
  id: string;
  title: string;
  element: HTMLElement;
  /** Called when the tab is selected, and periodically while it is shown. */
  show(): void;
}

export class Drawer {
  readonly element = h('section', { class: 'drawer', 'aria-label': 'Details' });
  private readonly tabs: HTMLButtonElement[];
  private current = 0;

  /** `tools`: buttons beside the tabs. */
  constructor(private readonly pages: Page[], ...tools: HTMLElement[]) {
    const list = h('div', { class: 'tabs', role: 'tablist' });
    this.tabs = pages.map((page, i) => {
      const tab = button({ role: 'tab', id: `tab-${page.id}`, 'aria-controls': `page-${page.id}` }, page.title, () => { this.choose(i); });
      tab.addEventListener('keydown', (event) => {
        const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (step === undefined) return;
        this.choose((this.current + step + pages.length) % pages.length);
        this.tabs[this.current]?.focus();
      });
      return tab;
    });
    list.append(...this.tabs);
    const size = button({ id: 'drawer-size', 'aria-pressed': 'false', title: 'More room for these pages' }, 'larger', () => {
      const large = document.body.classList.toggle('large-drawer');
      setAttribute(size, 'aria-pressed', String(large));
      setText(size, large ? 'smaller' : 'larger');
    });
    this.element.append(h('div', { class: 'drawer-head' }, list, ...tools, size));
    for (const page of pages) {
      setAttribute(page.element, 'id', `page-${page.id}`);
      setAttribute(page.element, 'role', 'tabpanel');
      setAttribute(page.element, 'aria-labelledby', `tab-${page.id}`);
      page.element.classList.add('page');
      this.element.append(page.element);
    }
    this.choose(0);
  }

  show(): void {
    this.pages[this.current]?.show();
  }

  get selected(): string {
    return this.pages[this.current]?.id ?? '';
  }

  select(id: string): void {
    this.choose(this.pages.findIndex((page) => page.id === id));
  }

  private choose(index: number): void {
    this.current = index;
    this.pages.forEach((page, i) => {
      const chosen = i === index;
      page.element.hidden = !chosen;
      const tab = this.tabs[i];
      if (tab === undefined) return;
      setAttribute(tab, 'aria-selected', String(chosen));
      tab.tabIndex = chosen ? 0 : -1;
    });
    this.show();
  }
}
