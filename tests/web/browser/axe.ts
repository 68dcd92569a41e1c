// What keeps somebody from reading a page, as axe finds it.
import axe from 'axe-core';
import type { Page } from 'playwright-core';

/** Serious findings in a part of the page, or in all of it. */
export async function findings(page: Page, within?: string): Promise<string[]> {
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(axe.source);
  return page.evaluate(async (part) => {
    // Nothing is kept of what passes: most of the time of a long page would go there.
    const { violations } = await (window as unknown as { axe: typeof axe }).axe.run(part ?? document, { resultTypes: ['violations'], preload: false });
    return violations
      .filter(({ impact }) => impact === 'serious' || impact === 'critical')
      .map(({ id, nodes }) => `${id}: ${nodes[0]?.html ?? ''}`);
  }, within);
}
