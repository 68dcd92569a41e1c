import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Robot, type Contact, type Listed } from '../../../daemon/web/robots/robot.ts';
import { kEnded_ms, RobotList } from '../../../daemon/web/robots/robot_list.ts';
import { FakeDaemon, message } from './fake_daemon.ts';

const kListed: Listed = { url: 'http://127.0.0.1:8766/', session: 'cd34' };

let daemon: FakeDaemon;
const robot = (listed = kListed): Robot => new Robot(listed, () => Date.now(), daemon.make);

/** A message of `/state`. */
function state(run: string): void {
  daemon.newest.say(message(1, { stop: { count: 0, latched: false, by: '', status: 'none' }, run }));
}

beforeEach(() => {
  vi.useFakeTimers();
  daemon = new FakeDaemon();
});
afterEach(() => {
  vi.useRealTimers();
});

describe('a robot of the list', () => {
  it('answers while its state comes', () => {
    const one = robot();
    expect(one.contact).toBe('connecting');
    daemon.newest.greet('cd34');
    state('running');
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
    daemon.newest.greet('cd34');
    state('running');
    daemon.newest.die();
    expect(one.contact).toBe('no_answer');
    const other = robot();
    vi.advanceTimersByTime(2100);
    expect(other.contact).toBe('no_answer');
  });

  it('sends STOP at once, and first of all when its daemon is back', () => {
    const one = robot();
    daemon.newest.greet('cd34');
    one.stop.press(Date.now());
    expect(daemon.newest.calls.length).toBe(1);
    daemon.newest.die();
    one.stop.press(Date.now());
    expect(one.stop.button.view(Date.now() + 300)).toMatchObject({ kind: 'not_acknowledged', waiting: true });
    vi.advanceTimersByTime(500);
    daemon.newest.greet('cd34');
    expect(daemon.sockets.length).toBeGreaterThan(1);
    expect(daemon.newest.calls.length).toBe(1);
    expect(daemon.newest.sent[0]).toBe(daemon.newest.calls[0]);
  });

  it('sends nothing to another daemon at its address, and shows nothing of it', () => {
    const one = robot();
    one.stop.press(Date.now());
    daemon.newest.greet('ffff');
    state('running');
    one.stop.press(Date.now());
    expect(one.contact).toBe('other');
    expect(one.state).toBeUndefined();
    expect(one.name).toBe('');
    expect(daemon.newest.calls.length).toBe(0);
  });

  it('is whatever daemon answers if the configuration names it', () => {
    const one = robot({ url: 'http://10.0.0.7:8765/' });
    daemon.newest.greet('ffff');
    state('idle');
    expect(one.contact).toBe('answers');
  });

  it('leaves nothing behind', () => {
    const one = robot();
    daemon.newest.greet('cd34');
    one.end();
    expect(daemon.newest.closed).toBe(true);
    vi.advanceTimersByTime(60_000);
    expect(daemon.sockets.length).toBe(1);
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
