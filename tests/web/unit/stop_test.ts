import { beforeEach, describe, expect, it } from 'vitest';
import type { StopState } from '../../../daemon/web/state/messages.ts';
import { kPatience_ms, StopButton } from '../../../daemon/web/state/stop.ts';

const kNone: StopState = { count: 0, latched: false, by: '', requested_t_s: null, status: 'none', acknowledged_ms: null };
const kLatched: StopState = { count: 1, latched: true, by: 'viewer 3', requested_t_s: 1, status: 'acknowledged', acknowledged_ms: 14.2 };

let stop: StopButton;
beforeEach(() => {
  stop = new StopButton();
});

describe('StopButton', () => {
  it('is ready at first, whatever is known', () => {
    expect(stop.view(0)).toEqual({ kind: 'ready' });
    stop.received(kNone);
    expect(stop.view(0)).toEqual({ kind: 'ready' });
  });

  it('goes from a press over the answer to stopped, with the time that the robot took', () => {
    stop.received(kNone);
    stop.press(1000);
    expect(stop.unsent).toBe(true);
    stop.sent();
    expect(stop.unsent).toBe(false);
    expect(stop.view(1010).kind).toBe('pending');
    stop.answered(true, 14.2);
    expect(stop.view(1020)).toMatchObject({ kind: 'stopped', took_ms: 14.2 });
  });

  it('says not acknowledged after its patience is over, not before', () => {
    stop.press(1000);
    stop.sent();
    expect(stop.view(1000 + kPatience_ms - 1).kind).toBe('pending');
    expect(stop.view(1000 + kPatience_ms)).toMatchObject({ kind: 'not_acknowledged', waiting: false });
  });

  it('says that it waits for the link when it could not be sent', () => {
    stop.press(0);
    expect(stop.view(500)).toMatchObject({ kind: 'not_acknowledged', waiting: true });
  });

  it('is to be sent again after a lost connection, until the robot has acknowledged', () => {
    stop.press(0);
    stop.sent();
    stop.disconnected();
    expect(stop.unsent).toBe(true);
    stop.sent();
    stop.answered(false, null);
    stop.disconnected();
    expect(stop.unsent).toBe(true);
    stop.sent();
    stop.answered(true, 9);
    stop.disconnected();
    expect(stop.unsent).toBe(false);
  });

  it('takes no older acknowledgement for its own', () => {
    stop.received(kLatched);
    stop.press(1000);
    stop.sent();
    stop.received(kLatched);
    expect(stop.view(1300).kind).toBe('not_acknowledged');
    stop.answered(false, null);
    stop.received({ ...kLatched, count: 2, status: 'not_acknowledged', acknowledged_ms: null });
    expect(stop.view(1400).kind).toBe('not_acknowledged');
  });

  it('believes an acknowledgement that comes late', () => {
    stop.press(0);
    stop.sent();
    stop.answered(false, null);
    stop.received({ ...kLatched, acknowledged_ms: 3210 });
    expect(stop.view(3300)).toMatchObject({ kind: 'stopped', took_ms: 3210 });
  });

  it('shows what another viewer stopped', () => {
    stop.received(kLatched);
    expect(stop.view(0)).toEqual({ kind: 'stopped', took_ms: 14.2, by: 'viewer 3' });
    stop.received({ ...kLatched, status: 'pending', acknowledged_ms: null });
    expect(stop.view(0).kind).toBe('pending');
    stop.received({ ...kLatched, status: 'not_acknowledged', acknowledged_ms: null });
    expect(stop.view(0).kind).toBe('not_acknowledged');
  });

  it('stays latched until a start', () => {
    stop.received(kLatched);
    expect(stop.view(1e9).kind).toBe('stopped');
    stop.received({ ...kLatched, latched: false, status: 'none' });
    expect(stop.view(1e9).kind).toBe('ready');
  });

  it('takes another press while it is latched', () => {
    stop.received(kLatched);
    stop.press(5000);
    expect(stop.unsent).toBe(true);
    stop.sent();
    stop.answered(true, 8);
    expect(stop.view(5100)).toMatchObject({ kind: 'stopped', took_ms: 8 });
  });
});
