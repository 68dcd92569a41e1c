// A course as it is drawn: its file keeps what a person wrote, and each point does what it is dragged for.
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { CourseText, written } from '../../../daemon/web/draw/course_text.ts';
import { added, handles } from '../../../daemon/web/draw/draft.ts';
import type { Point2 } from '../../../daemon/web/scene/geometry.ts';
import type { FloorPose } from '../../../daemon/web/state/messages.ts';
import { drawn } from './drawn.ts';

const course3 = readFileSync(new URL('../../../config/courses/3.toml', import.meta.url), 'utf8');
const course2 = readFileSync(new URL('../../../config/courses/2.toml', import.meta.url), 'utf8');

/** Lines that only one of the texts has. */
function difference(a: string, b: string): { lost: string[]; won: string[] } {
  const [before, after] = [a.split('\n'), b.split('\n')];
  return { lost: before.filter((line) => !after.includes(line)), won: after.filter((line) => !before.includes(line)) };
}

describe('the text of a course', () => {
  it('adds a piece behind those of its kind, and removes it without a trace', () => {
    const text = new CourseText(course3);
    for (const table of ['segment', 'block', 'disturbance', 'keep_out'] as const) {
      const more = new CourseText(text.added(table, { at_m: 1 }));
      expect(more.all(table)).toHaveLength(text.all(table).length + 1);
      expect(difference(course3, more.text).lost).toEqual([]);
      const last = more.all(table).at(-1);
      if (last !== undefined) expect(more.removed(last).trim()).toBe(course3.trim());
    }
  });

  it('adds a key to a table, and a table that is missing', () => {
    const text = new CourseText(course3);
    const moved = new CourseText(text.with(text.one('start'), { x_m: 0.1, y_m: 0 }));
    expect(moved.text).toContain('[start]\nx_m = 0.1\ny_m = 0.0\n\n[[segment]]');
    const turned = moved.with(moved.one('start'), { yaw_deg: 90 });
    expect(turned).toContain('[start]\nx_m = 0.1\ny_m = 0.0\nyaw_deg = 90.0\n');
    expect(difference(course3, turned).lost).toEqual([]);
  });

  it('changes values in one line, and refuses what it cannot write there', () => {
    const text = new CourseText('start = { x_m = 1.0, y_m = 2 } # here\nsegment = [{ type = "line", length_m = 1 }]\nfence.min_x_m = -1\n');
    expect(text.with(text.one('start'), { y_m: 2.5 })).toContain('start = { x_m = 1.0, y_m = 2.5 } # here');
    expect(text.with(text.one('fence'), { min_x_m: -2 })).toContain('fence.min_x_m = -2.0\n');
    expect(() => text.added('segment', { type: 'line' })).toThrow('change it in the text');
    expect(() => text.with(text.one('start'), { yaw_deg: 1 })).toThrow('change it in the text');
  });

  it('reads all dotted keys of a table', () => {
    const text = new CourseText('start.x_m = 1.0\nspeed_mps = 0.1\nstart.y_m = 2.0 # here\nfence.min_x_m = -1.0\n');
    expect(text.one('start').values).toEqual({ x_m: 1, y_m: 2 });
    expect(text.one('fence').values).toEqual({ min_x_m: -1 });
    expect(text.with(text.one('start'), { x_m: 3, y_m: 4 })).toContain('start.x_m = 3.0\nspeed_mps = 0.1\nstart.y_m = 4.0 # here\n');
  });

  it('writes numbers as people do', () => {
    expect(written([[1, 0.1 + 0.2], [-0.0004, 1.23456]])).toBe('[[1.0, 0.3], [0.0, 1.235]]');
  });
});

describe('a draft', () => {
  it('ends a segment where its point is pressed', () => {
    const start = '[start]\nx_m = 0.2\ny_m = -0.3\nyaw_deg = 30\n';
    const press = (tool: string, to: Point2): FloorPose | undefined => {
      const text = new CourseText(start);
      return drawn(new CourseText(added(text, drawn(text), tool, to).text)).segments[0]?.end;
    };
    for (const to of [{ x: 0.9, y: 0.4 }, { x: 0.5, y: -0.9 }, { x: -0.5, y: 0.1 }, { x: 0.2, y: 0.2 }]) {
      const end = press('arc', to);
      expect(Math.hypot((end?.x_m ?? 9) - to.x, (end?.y_m ?? 9) - to.y)).toBeLessThan(0.005);
      const turned = press('pivot', to)?.yaw_rad ?? 9;
      expect(Math.cos(turned - Math.atan2(to.y + 0.3, to.x - 0.2))).toBeCloseTo(1, 9);
    }
    const ahead = { x: 0.2 + Math.cos(Math.PI / 6), y: -0.3 + Math.sin(Math.PI / 6) };
    expect(press('line', ahead)?.x_m).toBeCloseTo(ahead.x, 3);
    expect(press('line', ahead)?.y_m).toBeCloseTo(ahead.y, 3);
    expect(Math.hypot((press('line', { x: -9, y: -9 })?.x_m ?? 9) - 0.2)).toBeCloseTo(0.01 * Math.cos(Math.PI / 6), 6);
  });

  it('changes nothing by a point that stays where it is', () => {
    for (const file of [course2, course3]) {
      const text = new CourseText(file);
      for (const handle of handles(text, drawn(text))) {
        const dragged = handle.drag(handle.at);
        if (handle.piece.table !== 'start') expect(difference(file, dragged).won, handle.id).toEqual([]);
        expect(() => new CourseText(dragged)).not.toThrow();
      }
    }
  });

  it('lists disturbances along the path', () => {
    let text = new CourseText(course3);
    for (const x of [0.9, 0.3, 0.6]) text = new CourseText(added(text, drawn(text), 'disturbance', { x, y: 0 }).text);
    const at = text.all('disturbance').map((each) => each.values.at_m);
    expect(at).toEqual([0.3, 0.6, 0.9]);
  });
});
