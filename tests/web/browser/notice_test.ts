import { describe, expect, it } from 'vitest';
import { driveUntil, picture, until } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting({ each: true });

describe('notices', () => {
  it('name the port, open the others, can be closed, and never cover the view', async () => {
    const page = await setting.open();
    await driveUntil(page, 'running');
    await until(async () => (await page.textContent('.badge')) === 'emulated', 'the kind of robot');
    await setting.pair.robot.end('SIGKILL');
    const rows = page.locator('#notice-list li');
    await until(async () => ((await rows.first().textContent()) ?? '').startsWith(`No robot on ${setting.pair.folder}/robot`), 'the port is named');
    expect(await rows.count()).toBe(1);
    await until(() => page.isVisible('#notice-more'), 'there is more');
    await page.click('#notice-more');
    await until(async () => (await rows.count()) > 1, 'the fault that ended the run');
    await picture(page, 'notices');
    const [notice, stage] = await Promise.all(['.notice', '.stage canvas'].map((selector) => page.locator(selector).boundingBox()));
    expect(notice?.y).toBeGreaterThanOrEqual((stage?.y ?? NaN) + (stage?.height ?? NaN) - 1);
    await page.click('#notice-close');
    await until(async () => (await page.getAttribute('.notice', 'data-level')) === 'none', 'it is closed');
  });
});
