// Nothing moves for a person who has not seen the last STOP.
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { Confirmation, Consent, kConfirm_ms } from '../../../daemon/web/state/consent.ts';
import type { State } from '../../../daemon/web/state/messages.ts';

const state = (t_s: number, count: number): State => ({ t_s, stop: { count } }) as State;

let sent: unknown[];
let consent: Consent;
beforeEach(() => {
  sent = [];
  consent = new Consent((service, request) => {
    sent.push([service, request]);
    return Promise.resolve({});
  });
});

describe('the consent of a person', () => {
  // Otherwise a start could cross a STOP that the person has not seen.
  it('is to what the page had shown, not to what it had received', async () => {
    consent.received(state(5, 2));
    await expect(consent.move('start', {})).rejects.toThrow('look, then press again');
    consent.shown();
    consent.received(state(5.2, 3));
    await consent.move('start', { from: 'here' });
    consent.shown();
    await consent.move('drive_take', {});
    expect(sent).toEqual([['start', { from: 'here', stops: 2, t_s: 5 }], ['drive_take', { stops: 3, t_s: 5.2 }]]);
  });

  it('to what was shown before STOP was pressed here, or before the connection ended, is none', async () => {
    consent.received(state(5, 2));
    consent.shown();
    consent.forget('STOP was pressed');
    consent.shown();
    await expect(consent.move('start', {})).rejects.toThrow('look, then press again');
    expect(sent).toEqual([]);
  });

  // Otherwise a question that was asked before a STOP would move the robot after it.
  it('ends with every STOP, wherever it was pressed, and with the connection', () => {
    const forget = vi.fn();
    consent.subscribe(forget);
    for (const t_s of [1, 2]) consent.received(state(t_s, 7));
    expect(forget).not.toHaveBeenCalled();
    consent.received(state(3, 8));
    consent.forget('The connection was lost');
    // Also one that came while there was no connection, or another daemon.
    consent.received(state(4, 9));
    consent.received(state(0.1, 0));
    expect(forget.mock.calls.flat()).toEqual(['STOP was pressed', 'The connection was lost', 'STOP was pressed', 'STOP was pressed']);
  });
});

describe('a confirmation', () => {
  let now_ms = 0;
  let confirmation: Confirmation;
  beforeEach(() => {
    confirmation = new Confirmation(consent, () => now_ms);
  });

  it('is a second press after the question was shown, in time', () => {
    expect(confirmation.press()).toBe(false);
    expect(confirmation.press(), 'a double click').toBe(false);
    expect(confirmation.show()).toBe(true);
    expect(confirmation.press()).toBe(true);
    expect(confirmation.show()).toBe(false);
    expect(confirmation.press(), 'the next one').toBe(false);
    confirmation.show();
    now_ms += kConfirm_ms;
    expect(confirmation.press(), 'too late').toBe(false);
    expect(confirmation.press(), 'a double click').toBe(false);
  });

  it('begins anew after a STOP', () => {
    for (const stop of [() => { consent.forget('STOP was pressed'); }, () => { consent.received(state(2, 1)); }]) {
      consent.received(state(1, 0));
      confirmation.press();
      confirmation.show();
      stop();
      expect(confirmation.press()).toBe(false);
    }
  });
});
