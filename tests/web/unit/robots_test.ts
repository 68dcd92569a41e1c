import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Robot, type Contact, type Listed } from '../../../daemon/web/robots/robot.ts';
import { kEnded_ms, RobotList } from '../../../daemon/web/robots/robot_list.ts';
import { FakeSocket } from './fake_socket.ts';

const kListed: Listed = { url: 'http://127.0.0.1:8766/', session: 'cd34' };

let sockets: FakeSocket[];
const newest = (): FakeSocket => sockets.at(-1) ?? new FakeSocket();

function robot(listed = kListed): Robot {
  return new Robot(listed, () => Date.now(), () => {
    sockets.push(new FakeSocket());
    return newest();
  });
}

function greet(session: string): void {
  newest().open();
  newest().json({ op: 'serverInfo', name: 'tp100d', capabilities: [], sessionId: session, metadata: { name: 'left' } });
  newest().json({ op: 'advertise', channels: [{ id: 1, topic: '/state', encoding: 'json', schemaName: 's', schema: '' }] });
  newest().json({ op: 'advertiseServices', services: [{ id: 3, name: 'stop', type: 's', requestSchema: '', responseSchema: '' }] });
}

/** A message of `/state`, as subscription 1. */
function state(content: object): void {
  const json = new TextEncoder().encode(JSON.stringify({ stop: { count: 0, latched: false, by: '', status: 'none' }, ...content }));
  const frame = new Uint8Array(13 + json.length);
  frame.set([1, 1, 0, 0, 0], 0);
  frame.set(json, 13);
  newest().say(frame.buffer);
}

/** Calls of a service that were sent: binary frames. */
const calls = (): number => newest().sent.filter((each) => typeof each !== 'string').length;

beforeEach(() => {
  vi.useFakeTimers();
  sockets = [];
});
afterEach(() => {
  vi.useRealTimers();
});

describe('a robot of the list', () => {
  it('answers while its state comes', () => {
    const one = robot();
    expect(one.contact).toBe('connecting');
    greet('cd34');
    state({ run: 'running' });
    expect(one.contact).toBe('answers');
    expect(one.name).toBe('left');
    expect(one.state?.run).toBe('running');
    vi.advanceTimersByTime(900);
    expect(one.contact).toBe('answers');
    vi.advanceTimersByTime(200);
    expect(one.contact).toBe('no_answer');
  });

  it('does not answer when its connection ends, or there never was one', () => {
    const one = robot();
    greet('cd34');
    state({ run: 'running' });
    newest().die();
    expect(one.contact).toBe('no_answer');
    const other = robot();
    vi.advanceTimersByTime(2100);
    expect(other.contact).toBe('no_answer');
  });

  it('sends STOP at once, and first of all when its daemon is back', () => {
    const one = robot();
    greet('cd34');
    one.stop.press(Date.now());
    expect(calls()).toBe(1);
    newest().die();
    one.stop.press(Date.now());
    expect(one.stop.button.view(Date.now() + 300)).toMatchObject({ kind: 'not_acknowledged', waiting: true });
    vi.advanceTimersByTime(500);
    greet('cd34');
    expect(sockets.length).toBeGreaterThan(1);
    expect(calls()).toBe(1);
    const first = newest().sent.findIndex((each) => typeof each !== 'string');
    expect(newest().sent.slice(0, first)).toEqual([]);
  });

  it('sends nothing to another daemon at its address, and shows nothing of it', () => {
    const one = robot();
    one.stop.press(Date.now());
    greet('ffff');
    state({ run: 'running' });
    one.stop.press(Date.now());
    expect(one.contact).toBe('other');
    expect(one.state).toBeUndefined();
    expect(one.name).toBe('');
    expect(calls()).toBe(0);
  });

  it('is whatever daemon answers if the configuration names it', () => {
    const one = robot({ url: 'http://10.0.0.7:8765/' });
    greet('ffff');
    state({ run: 'idle' });
    expect(one.contact).toBe('answers');
  });

  it('leaves nothing behind', () => {
    const one = robot();
    greet('cd34');
    one.end();
    expect(newest().closed).toBe(true);
    vi.advanceTimersByTime(60_000);
    expect(sockets.length).toBe(1);
    expect(vi.getTimerCount()).toBe(0);
  });
});

describe('the list of robots', () => {
  class Member {
    contact: Contact = 'answers';
    gone = false;
    constructor(readonly listed: Listed) {}
    end(): void {
      this.gone = true;
    }
  }
  const kOther: Listed = { url: 'http://127.0.0.1:8767/', session: 'ef56' };

  it('has each once, as long as it is listed', () => {
    const list = new RobotList((listed) => new Member(listed));
    list.take([kListed, kOther, kOther], 0);
    list.take([kOther, kListed], 1000);
    expect(list.robots.map(({ listed }) => listed)).toEqual([kListed, kOther]);
  });

  it('says for a minute that a daemon has ended', () => {
    const list = new RobotList((listed) => new Member(listed));
    list.take([kListed, kOther], 0);
    const [one, other] = list.robots as [Member, Member];
    one.contact = 'no_answer';
    list.take([kOther], 1000);
    expect([list.ended(one), list.ended(other)]).toEqual([true, false]);
    list.take([kOther], 1000 + kEnded_ms - 1);
    expect(list.robots).toEqual([one, other]);
    list.take([kOther], 1000 + kEnded_ms);
    expect(list.robots).toEqual([other]);
    expect([one.gone, other.gone]).toEqual([true, false]);
  });

  it('keeps one that hangs, and one that answers though it is not listed', () => {
    const list = new RobotList((listed) => new Member(listed));
    list.take([kListed, kOther], 0);
    const [hangs, answers] = list.robots as [Member, Member];
    hangs.contact = 'no_answer';
    for (let now_ms = 0; now_ms < 3 * kEnded_ms; now_ms += 1000) list.take([kListed], now_ms);
    expect(list.robots).toEqual([hangs, answers]);
    expect([list.ended(hangs), list.ended(answers)]).toEqual([false, false]);
  });

  it('shows a restarted daemon beside the one that ended', () => {
    const old = new Member(kListed);
    const list = new RobotList((listed) => (listed === kListed ? old : new Member(listed)));
    list.take([kListed], 0);
    old.contact = 'no_answer';
    const again = { ...kListed, session: '9abc' };
    list.take([again], 1000);
    expect(list.robots.map(({ listed }) => listed.session)).toEqual(['cd34', '9abc']);
    // It turns out that the address is the new one's.
    old.contact = 'other';
    list.take([again], 2000);
    expect(list.robots.map(({ listed }) => listed.session)).toEqual(['9abc']);
  });
});
