// A course as it is drawn: its file keeps what a person wrote, and each point does what it is dragged for.
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { CourseText, written } from '../../../daemon/web/draw/course_text.ts';
import { added, handles } from '../../../daemon/web/draw/draft.ts';
import { along, arcTo, frames, lineTo, startOf } from '../../../daemon/web/draw/path.ts';

const course3 = readFileSync(new URL('../../../config/courses/3.toml', import.meta.url), 'utf8');
const course2 = readFileSync(new URL('../../../config/courses/2.toml', import.meta.url), 'utf8');

function only<T>([piece]: readonly T[]): T {
  if (piece === undefined) throw new Error('no such piece');
  return piece;
}

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

  it('writes numbers as people do', () => {
    expect(written([[1, 0.1 + 0.2], [-0.0004, 1.23456]])).toBe('[[1.0, 0.3], [0.0, 1.235]]');
  });
});

describe('a draft', () => {
  it('ends a line or an arc where its point is dragged to', () => {
    const from = startOf(new CourseText('[start]\nx_m = 0.2\ny_m = -0.3\nyaw_deg = 30\n').one('start'));
    for (const to of [{ x: 0.9, y: 0.4 }, { x: 0.5, y: -0.9 }, { x: -0.5, y: 0.1 }, { x: 0.2, y: 0.2 }]) {
      const { radius_m, angle_deg } = arcTo(from, to);
      const arc = only(new CourseText(`[[segment]]\ntype = "arc"\nradius_m = ${radius_m}\nangle_deg = ${angle_deg}\n`).all('segment'));
      expect(along(from, arc).x).toBeCloseTo(to.x, 3);
      expect(along(from, arc).y).toBeCloseTo(to.y, 3);
    }
    expect(lineTo(from, { x: 0.2 + Math.cos(Math.PI / 6), y: -0.3 + Math.sin(Math.PI / 6) })).toBeCloseTo(1, 9);
    expect(lineTo(from, { x: -9, y: -9 })).toBe(0.01);
    // The robot at 30 degrees turns to a point that is straight to the left of the course's frame.
    const pivot = added(new CourseText('[start]\nyaw_deg = 30\n'), 'pivot', { x: 0, y: 1 }).text;
    expect(only(new CourseText(pivot).all('segment')).values.angle_deg).toBeCloseTo(60, 6);
  });

  it('has its path where the daemon has it', () => {
    const text = new CourseText(course3);
    const end = frames(startOf(text.one('start')), text.all('segment')).at(-1);
    expect(end?.x).toBeCloseTo(0, 6);
    expect(end?.y).toBeCloseTo(-0.8, 6);
    expect(end?.s_m).toBeCloseTo(2.8 + 0.4 * Math.PI, 6);
  });

  it('changes nothing by a point that stays where it is', () => {
    for (const file of [course2, course3]) {
      const text = new CourseText(file);
      for (const handle of handles(text)) {
        const dragged = handle.drag(handle.at);
        if (handle.piece.table !== 'start') expect(difference(file, dragged).won, handle.id).toEqual([]);
        expect(() => new CourseText(dragged)).not.toThrow();
      }
    }
  });

  it('lists disturbances along the path', () => {
    let text = new CourseText(course3);
    for (const x of [0.9, 0.3, 0.6]) text = new CourseText(added(text, 'disturbance', { x, y: 0 }).text);
    const at = text.all('disturbance').map((each) => each.values.at_m);
    expect(at).toEqual([0.3, 0.6, 0.9]);
  });
});
