// The colours of both themes: enough contrast, and none missing.
import { readFileSync, readdirSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

const kWeb = new URL('../../../daemon/web/', import.meta.url);

/** The colours of page/theme.css by name. */
function colours(theme: 'dark' | 'light'): Map<string, string> {
  const text = readFileSync(new URL('page/theme.css', kWeb), 'utf8');
  const from = text.indexOf(theme === 'dark' ? ':root {' : ":root[data-theme='light'] {");
  const block = text.slice(from, text.indexOf('}', from));
  return new Map([...block.matchAll(/--([\w-]+): (#[0-9a-f]+);/g)].map(([, name = '', value = '']) => [name, value]));
}

/** Relative luminance, as WCAG 2 defines it. */
function luminance(colour: string): number {
  const [r = 0, g = 0, b = 0] = [1, 3, 5].map((at) => {
    const share = parseInt(colour.slice(at, at + 2), 16) / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

function contrast(one: string, other: string): number {
  const [low = 0, high = 0] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (high + 0.05) / (low + 0.05);
}

describe.each(['dark', 'light'] as const)('the %s theme', (theme) => {
  const all = colours(theme);
  const of = (name: string): string => all.get(name) ?? '#7f7f7f';

  it('has text that is read easily, also where it is stale', () => {
    const poor: string[] = [];
    const check = (texts: string[], grounds: string[]): void => {
      for (const text of texts)
        for (const ground of grounds)
          if (!(contrast(of(text), of(ground)) >= 4.5)) poor.push(`${text} on ${ground}: ${contrast(of(text), of(ground)).toFixed(2)}`);
    };
    check(['text', 'strong', 'dim', 'faint', 'good', 'wait', 'warn', 'bad', 'link', 'record'], ['ground', 'panel']);
    check(['text', 'strong', 'dim', 'wait', 'warn', 'bad'], ['raised']);
    check(['text', 'strong'], ['hover', 'pressed']);
    check(['path', 'truth', 'model', 'odometry', 'fused', 'left', 'right', 'value', 'run-2', 'run-3', 'run-5'], ['panel']);
    check(['path', 'truth', 'model', 'odometry', 'fused'], ['floor', 'sky']);
    check(['on-warn'], ['warn']);
    check(['go-text'], ['go-ground', 'go-hover']);
    check(['past-text'], ['past-ground', 'past-raised', 'past-hover']);
    check(['past-dim'], ['past-ground']);
    expect(poor).toEqual([]);
  });

  it('has every colour that the pages use', () => {
    const text = ['page', 'panel', 'scene', 'robots', 'draw'].flatMap((folder) =>
      readdirSync(new URL(`${folder}/`, kWeb)).map((file) => readFileSync(new URL(`${folder}/${file}`, kWeb), 'utf8')),
    ).join('\n');
    const used = new Set([...text.matchAll(/var\(--([\w-]+)[),]/g), ...text.matchAll(/\bcolour\('([\w-]+)'\)/g)].map(([, name = '']) => name));
    for (const elsewhere of ['lamp', 'stop', 'sans', 'indent', 'side-width', 'plot-height']) used.delete(elsewhere);
    expect([...used].filter((name) => !all.has(name))).toEqual([]);
    expect(used.size).toBeGreaterThan(30);
  });

  it('has every colour of the other', () => {
    const other = colours(theme === 'dark' ? 'light' : 'dark');
    expect([...all.keys()].sort()).toEqual([...other.keys()].sort());
  });
});
