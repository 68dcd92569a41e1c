import { describe, expect, it } from 'vitest';
import { timeLeft_s } from '../../../daemon/web/panel/timeline.ts';
import type { Course, State } from '../../../daemon/web/state/messages.ts';

const course = { length_m: 4, speed_mps: 0.1, segments: [{ kind: 'line', from_m: 0, to_m: 2, angle_rad: 0 }, { kind: 'pivot', from_m: 2, to_m: 2, angle_rad: -1.2 }] } as unknown as Course;
const state = (more: Partial<State>): State => ({ run: 'running', progress_m: 0, run_s: 0, ...more }) as State;

describe('the time left', () => {
  it('is the nominal one at first, with turns on the spot', () => {
    expect(timeLeft_s(state({}), course)).toBeCloseTo(42);
    expect(timeLeft_s(state({ progress_m: 2, run_s: 22 }), course)).toBeCloseTo(20);
  });

  it('follows the pace of the run', () => {
    expect(timeLeft_s(state({ progress_m: 1, run_s: 15 }), course)).toBeCloseTo(32 * 1.5);
    expect(timeLeft_s(state({ progress_m: 1, run_s: 1000 }), course), 'after a pause').toBeCloseTo(64);
    expect(timeLeft_s(state({ progress_m: 5, run_s: 60 }), course)).toBe(0);
  });

  it('is not known without a run or a course, or while it pauses', () => {
    expect(timeLeft_s(state({ run: 'idle' }), course)).toBeUndefined();
    expect(timeLeft_s(state({ pause_left_s: 3 }), course)).toBeUndefined();
    expect(timeLeft_s(state({}), undefined)).toBeUndefined();
    expect(timeLeft_s(state({}), { length_m: 0, speed_mps: 0 } as Course)).toBeUndefined();
  });
});
