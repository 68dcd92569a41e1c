// The theme, dark or light: the system's preference, or the last choice in this browser.
import { button, icon, setAttribute } from '../panel/dom.ts';
import { colour, forgetColours } from '../scene/palette.ts';

type Theme = 'dark' | 'light';

const kKey = 'tp100.theme';
const kPreference = matchMedia('(prefers-color-scheme: light)');

const preferred = (): Theme => (kPreference.matches ? 'light' : 'dark');

/** The stored choice; undefined if there is none or the browser denies storage. */
function kept(): Theme | undefined {
  try {
    const theme = localStorage.getItem(kKey);
    return theme === 'dark' || theme === 'light' ? theme : undefined;
  } catch {
    return undefined;
  }
}

function keep(theme: Theme): void {
  try {
    // The system's preference is not stored, so that the page follows when it changes.
    if (theme === preferred()) localStorage.removeItem(kKey);
    else localStorage.setItem(kKey, theme);
  } catch {
    // Without storage the choice lasts as long as the page.
  }
}

const current = (): string | undefined => document.documentElement.dataset.theme;

function apply(theme: Theme): void {
  document.documentElement.dataset.theme = theme;
  forgetColours();
  document.querySelector('meta[name="theme-color"]')?.setAttribute('content', colour('panel'));
}

// Set before anything is drawn.
apply(kept() ?? preferred());

/** A button that switches to the other theme. `changed`: redraws what is drawn by scripts. */
export function themeSwitch(changed: () => void): HTMLElement {
  const element = button({ class: 'theme-switch', title: 'Light or dark page', 'aria-label': 'Light page' }, icon('theme'), () => {
    const theme = current() === 'light' ? 'dark' : 'light';
    keep(theme);
    use(theme);
  });
  const use = (theme: Theme): void => {
    if (theme !== current()) {
      apply(theme);
      changed();
    }
    setAttribute(element, 'aria-pressed', String(theme === 'light'));
  };
  kPreference.addEventListener('change', () => { use(kept() ?? preferred()); });
  use(kept() ?? preferred());
  return element;
}
