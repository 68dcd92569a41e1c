// The page of all robots: what it knows of each, STOP for one that does not answer, and which it lists.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { kEnded_ms, Robot, RobotList, type Contact, type Listed } from '../../../daemon/web/robots/robot.ts';
import { FakeDaemon, message } from './fake_daemon.ts';

const kListed: Listed = { url: 'http://127.0.0.1:8766/', session: 'cd34' };

describe('a robot of the list', () => {
  let daemon: FakeDaemon;
  const robot = (listed = kListed): Robot => new Robot(listed, () => Date.now(), daemon.make);
  /** The daemon answers, and sends `/state`. */
  const answers = (session = 'cd34'): void => {
    daemon.newest.greet(session);
    daemon.newest.say(message(1, { stop: { count: 0, latched: false, by: '', status: 'none' }, run: 'running' }));
  };

  beforeEach(() => {
    vi.useFakeTimers();
    daemon = new FakeDaemon();
  });
  afterEach(() => {
    vi.useRealTimers();
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

  it('sends nothing to another daemon at its address, and shows nothing of it, unless the configuration names the address', () => {
    const one = robot();
    one.stop.press(Date.now());
    answers('ffff');
    one.stop.press(Date.now());
    expect([one.contact, one.state, one.name]).toEqual(['other', undefined, '']);
    expect(daemon.newest.calls.length).toBe(0);
    const named = robot({ url: 'http://10.0.0.7:8765/' });
    answers('ffff');
    expect(named.contact).toBe('answers');
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
  let list: RobotList<Member>;
  let one: Member, other: Member;
  beforeEach(() => {
    list = new RobotList((listed) => new Member(listed));
    list.take([kListed, kOther, kOther], 0);
    [one, other] = list.robots as [Member, Member];
  });

  it('has each once, as long as it is listed, and says for a minute that a daemon has ended', () => {
    list.take([kOther, kListed], 500);
    expect(list.robots).toEqual([one, other]);
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
    one.contact = 'no_answer';
    for (let now_ms = 0; now_ms < 3 * kEnded_ms; now_ms += 1000) list.take([kListed], now_ms);
    expect(list.robots).toEqual([one, other]);
    expect([list.ended(one), list.ended(other)]).toEqual([false, false]);
  });

  it('shows a restarted daemon beside the one that ended, until its address is known to be the new one’s', () => {
    one.contact = 'no_answer';
    const again = { ...kListed, session: '9abc' };
    const sessions = (now_ms: number): unknown[] => {
      list.take([kOther, again], now_ms);
      return list.robots.map(({ listed }) => listed.session);
    };
    expect(sessions(1000)).toEqual(['cd34', 'ef56', '9abc']);
    one.contact = 'other';
    expect(sessions(2000)).toEqual(['ef56', '9abc']);
  });
});
