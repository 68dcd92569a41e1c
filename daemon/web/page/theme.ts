// The theme, dark or light: as the system prefers, or as this browser was told last.
import { h, icon, setAttribute } from '../panel/dom.ts';
import { colour, forgetColours } from '../scene/palette.ts';

type Theme = 'dark' | 'light';

const kKey = 'tp100.theme';
const kPreference = matchMedia('(prefers-color-scheme: light)');

const preferred = (): Theme => (kPreference.matches ? 'light' : 'dark');

/** A browser may refuse to keep anything. */
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
    // What the system prefers is followed, also when that changes.
    if (theme === preferred()) localStorage.removeItem(kKey);
    else localStorage.setItem(kKey, theme);
  } catch {
    // It lasts as long as the page.
  }
}

const current = (): string | undefined => document.documentElement.dataset.theme;

function apply(theme: Theme): void {
  document.documentElement.dataset.theme = theme;
  forgetColours();
  document.querySelector('meta[name="theme-color"]')?.setAttribute('content', colour('panel'));
}

// Before anything is drawn.
apply(kept() ?? preferred());

/** A button for the other theme. `changed`: what was drawn by script has to be drawn anew. */
export function themeSwitch(changed: () => void): HTMLElement {
  const button = h('button', { type: 'button', class: 'theme-switch', title: 'Light or dark page', 'aria-label': 'Light page' }, icon('theme'));
  const use = (theme: Theme): void => {
    if (theme !== current()) {
      apply(theme);
      changed();
    }
    setAttribute(button, 'aria-pressed', String(theme === 'light'));
  };
  button.addEventListener('click', () => {
    const theme = current() === 'light' ? 'dark' : 'light';
    keep(theme);
    use(theme);
  });
  kPreference.addEventListener('change', () => { use(kept() ?? preferred()); });
  use(kept() ?? preferred());
  return button;
}
