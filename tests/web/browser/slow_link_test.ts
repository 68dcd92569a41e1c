// The page over a slow link, and what pages cost the daemon.
import { readFile, readdir } from 'node:fs/promises';
import { connect, createServer, type AddressInfo, type Socket } from 'node:net';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { figure, goOn, openBrowser, openPage, press, rest, run, shows, until } from './cockpit.ts';
import { Pair } from './programs.ts';

/** A link between here and the daemon, shared by all connections: bytes come late, and only so many a second. */
class Link {
  port = 0;
  received = 0;
  private readonly sockets = new Set<Socket>();
  private readonly server = createServer((near) => { this.join(near); });
  private free_ms = { down: 0, up: 0 };

  constructor(
    private readonly to: URL,
    private readonly bytes_ps: number,
    private readonly delay_ms: number,
  ) {}

  async open(): Promise<string> {
    await new Promise<void>((resolve) => this.server.listen(0, '127.0.0.1', resolve));
    return `http://127.0.0.1:${(this.server.address() as AddressInfo).port}/`;
  }

  close(): void {
    for (const socket of this.sockets) socket.destroy();
    this.server.close();
  }

  private join(near: Socket): void {
    const far = connect(Number(this.to.port), this.to.hostname);
    this.carry(near, far, 'up');
    this.carry(far, near, 'down');
  }

  private carry(from: Socket, into: Socket, way: 'down' | 'up'): void {
    this.sockets.add(from);
    from.on('data', (data: Buffer) => {
      if (way === 'down') this.received += data.length;
      const now_ms = performance.now();
      this.free_ms[way] = Math.max(this.free_ms[way], now_ms) + (1000 * data.length) / this.bytes_ps;
      // Like a router, it holds half a second and more of data before it tells the sender.
      if (this.free_ms[way] - now_ms > 500) {
        from.pause();
        setTimeout(() => from.resume(), this.free_ms[way] - now_ms - 400);
      }
      setTimeout(() => { if (!into.destroyed) into.write(data); }, this.free_ms[way] - now_ms + this.delay_ms);
    });
    const end = (): void => {
      this.sockets.delete(from);
      setTimeout(() => into.destroy(), Math.max(0, this.free_ms[way] - performance.now()) + this.delay_ms + 50);
    };
    from.on('close', end);
    from.on('error', end);
  }
}

let pair: Pair;
let browser: Browser;

beforeAll(async () => {
  pair = await Pair.start(() => []);
  browser = await openBrowser();
});
afterAll(async () => {
  await browser.close();
  await pair.end();
});

test('over 20 kB/s with a round trip of 300 ms the page comes, says that the link is slow, shows the robot, drives and stops it', async () => {
  const link = new Link(new URL(pair.url), 20_000, 150);
  const complaints: string[] = [];
  const began_ms = performance.now();
  const page = await openPage(browser, await link.open(), complaints);
  await until(() => page.isVisible('#stop'), 'STOP');
  const stop_s = (performance.now() - began_ms) / 1000;
  await until(async () => Number.isFinite(await figure(page, 'x')), 'figures');
  const figures_s = (performance.now() - began_ms) / 1000;
  console.log(`20 kB/s, 300 ms: STOP after ${stop_s.toFixed(1)} s, figures after ${figures_s.toFixed(1)} s, ${link.received} bytes`);
  await until(async () => { await goOn(page); return (await run(page)) === 'running'; }, 'it runs');
  const [from, bytes, x] = [performance.now(), link.received, await figure(page, 'x')];
  await until(async () => (await figure(page, 'x')) > x + 0.1 || (await run(page)) !== 'running', 'it moves');
  await new Promise((resolve) => setTimeout(resolve, 3000));
  const seconds = (performance.now() - from) / 1000;
  console.log(`while driving: ${((link.received - bytes) / seconds / 1000).toFixed(1)} kB/s; link: ${await page.textContent('#chip-link')}`);
  const pressed_ms = performance.now();
  await press(page, '#stop');
  await shows(page, '#stop', /stopped|acknowledged/);
  console.log(`STOP is acknowledged on the page after ${((performance.now() - pressed_ms) / 1000).toFixed(2)} s`);
  expect(complaints).toEqual([]);
  await page.close();
  link.close();
});

test('over 3 kB/s the page says that the link is slow, and its poses are not late', async () => {
  const link = new Link(new URL(pair.url), 200_000, 150);
  const page = await openPage(browser, await link.open(), []);
  await until(async () => Number.isFinite(await figure(page, 'x')), 'figures');
  (link as unknown as { bytes_ps: number }).bytes_ps = 3000;
  await until(async () => { await goOn(page); return (await run(page)) === 'running'; }, 'it runs');
  await shows(page, '#chip-link', 'slow link');
  await shows(page, '.notice', 'connection to the daemon is slow');
  console.log(`3 kB/s: ${await page.getAttribute('#chip-link', 'title')}`);
  await rest(page);
  await page.close();
  link.close();
});

test('an idle page takes less than 10 kB/s', async () => {
  const link = new Link(new URL(pair.url), 10_000_000, 0);
  const page = await openPage(browser, await link.open(), []);
  await until(async () => Number.isFinite(await figure(page, 'x')), 'figures');
  await rest(page);
  await new Promise((resolve) => setTimeout(resolve, 4000));
  const before = link.received;
  await new Promise((resolve) => setTimeout(resolve, 10_000));
  const rate = (link.received - before) / 10_000;
  console.log(`an idle page takes ${rate.toFixed(1)} kB/s`);
  expect(rate).toBeLessThan(10);
  await page.close();
  link.close();
});

/** Seconds of a processor that threads of the daemon have used, by name. */
async function used(pid: number): Promise<Record<string, number>> {
  const out: Record<string, number> = {};
  for (const thread of await readdir(`/proc/${pid}/task`)) {
    const stat = await readFile(`/proc/${pid}/task/${thread}/stat`, 'utf8');
    const name = stat.slice(stat.indexOf('(') + 1, stat.lastIndexOf(')'));
    const fields = stat.slice(stat.lastIndexOf(')') + 2).split(' ');
    out[name] = (out[name] ?? 0) + (Number(fields[11]) + Number(fields[12])) / 100;
  }
  return out;
}

test('thirty pages that look on cost little', async () => {
  const page = await openPage(browser, pair.url, []);
  await until(async () => Number.isFinite(await figure(page, 'x')), 'figures');
  const share = async (moving: boolean): Promise<string> => {
    const before = await used(pair.daemon.pid);
    await new Promise((resolve) => setTimeout(resolve, 6000));
    const after = await used(pair.daemon.pid);
    return `${moving ? 'driving' : 'idle'}: ${['sockets', 'server'].map((name) => `${name} ${(((after[name] ?? 0) - (before[name] ?? 0)) / 0.06).toFixed(1)} %`).join(', ')}`;
  };
  await rest(page);
  console.log(`1 page, ${await share(false)}`);
  const look = (estimate_ms: number, slip_ms: number, link_ms: number): Promise<void> => page.evaluate(([e, s, l]) => {
    const all = window as unknown as { lookers?: WebSocket[] };
    for (const each of all.lookers ?? []) each.close();
    all.lookers = Array.from({ length: 30 }, () => {
      const socket = new WebSocket(location.origin.replace('http', 'ws'), ['foxglove.sdk.v1']);
      socket.onmessage = ({ data }) => {
        if (typeof data !== 'string' || !data.includes('"advertise"')) return;
        const { channels } = JSON.parse(data) as { channels: { id: number; topic: string }[] };
        const wanted: Record<string, number | undefined> = { '/estimate': e, '/slip': s, '/link': l, '/state': 0, '/event': 0, '/recording': 0, '/path_history': 0 };
        socket.send(JSON.stringify({ op: 'subscribe', subscriptions: channels.filter(({ topic }) => topic in wanted).map(({ id, topic }) => ({ id, channelId: id, interval_ms: wanted[topic] })) }));
      };
      return socket;
    });
  }, [estimate_ms, slip_ms, link_ms]);
  await look(200, 400, 1000);
  await new Promise((resolve) => setTimeout(resolve, 2000));
  console.log(`31 pages, ${await share(false)}`);
  await look(40, 100, 500);
  await until(async () => { await goOn(page); return (await run(page)) === 'running'; }, 'it runs');
  console.log(`31 pages, ${await share(true)}`);
  await page.close();
});
