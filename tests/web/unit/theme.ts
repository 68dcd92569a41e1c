// The colours of page/theme.css, by theme and name.
import { readFileSync } from 'node:fs';

const kFile = new URL('../../../daemon/web/page/theme.css', import.meta.url);

export type Theme = 'dark' | 'light';
export const kThemes: readonly Theme[] = ['dark', 'light'];

export function colours(theme: Theme): Map<string, string> {
  const text = readFileSync(kFile, 'utf8');
  const selector = theme === 'dark' ? ':root {' : ":root[data-theme='light'] {";
  const from = text.indexOf(selector);
  const block = text.slice(from, text.indexOf('}', from));
  return new Map([...block.matchAll(/--([\w-]+): (#[0-9a-f]+);/g)].map(([, name = '', value = '']) => [name, value]));
}
