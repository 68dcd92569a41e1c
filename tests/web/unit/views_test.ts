// What the page says of the robot's state, what it asks for next, and its address.
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { kHelp } from '../../../daemon/web/panel/help.ts';
import { nextStep } from '../../../daemon/web/panel/next_step.ts';
import { formatAddress, parseAddress, valueIn } from '../../../daemon/web/page/views.ts';
import type { State } from '../../../daemon/web/state/messages.ts';
import { runWords } from '../../../daemon/web/state/run_words.ts';

const kState = {
  run: 'idle', session: 'ready', motors_on: false, course: '3', length_m: 4.06, why_not_start: '', stop: { latched: false }, faults: [], can: { start: true },
} as unknown as State;
const state = (changes: Partial<State>): State => ({ ...kState, ...changes });
const words = (changes: Partial<State>): string => {
  const { lamp, word, detail } = runWords(state(changes));
  return `${lamp} ${word}, ${detail}`;
};
const step = (changes: Partial<State>): string => nextStep(state(changes), true, false, false).text;

it('the state of a run is told in words that a person knows', () => {
  expect(words({})).toBe('none ready, motors off');
  expect(words({ can: { ...kState.can, start: false }, why_not_start: 'no course' })).toBe('none not ready, no course');
  expect(words({ run: 'running', motors_on: true, run_s: 17.4 })).toBe('good running, 0:17.4');
  expect(words({ run: 'running', motors_on: true, run_s: 17.4, pause_left_s: 111.6 })).toBe('warn paused, motors on, ends in 1:52');
  expect(words({ run: 'finished', run_s: 42 })).toBe('done completed, 0:42.0');
  // A STOP that somebody wanted is no fault.
  expect(words({ run: 'aborted', run_s: 1, stop: { ...kState.stop, latched: true } })).toBe('bad stopped, 0:01.0');
  const fault = { name: 'fence', cause: '', fix: '' } as unknown as State['faults'][number];
  const late = 'bad aborted, 0:01.0';
  expect(words({ run: 'aborted', run_s: 1, faults: [fault], stop: { ...kState.stop, latched: true } }), 'a STOP after the end').toBe(late);
  expect(words({ run: 'aborted', run_s: 1 })).toBe(late);
  expect(words({ run: 'arming' })).toBe('wait starting, motors off');
  expect(words({ session: 'closed' })).toBe('bad no robot, no port');
  expect(words({ motors_on: true })).toBe('bad motors on, without a run');
});

it('the next step is told, and why Start is grey', () => {
  expect(step({})).toBe('Put the robot at the start of course 3, 4.06 m, and press Start.');
  expect(step({ session: 'closed' })).toMatch(/^Plug the robot in/);
  expect(nextStep(state({ course: '' }), true, false, false).link?.[0]).toBe('#plan');
  expect(step({ can: { ...kState.can, start: false }, why_not_start: 'the battery is too low' })).toBe('Not now: the battery is too low.');
  expect(step({ run: 'running', pause_left_s: 100 })).toContain('Resume');
  expect(step({ run: 'driving' }), 'another page drives').not.toContain('Arrow keys');
  expect(nextStep(state({ run: 'driving' }), true, false, true).text).toContain('Arrow keys');
  expect(nextStep(kState, true, true, false).text).toContain('the robot will move');
  expect(nextStep(kState, false, false, false).text).toContain('server.commands');
});

describe('the address', () => {
  it('has the view, its tab, and whatever else was there', () => {
    expect(parseAddress('')).toEqual({ view: 'drive', tab: '', others: [] });
    expect(parseAddress('#setup/link')).toEqual({ view: 'setup', tab: 'link', others: [] });
    const both = parseAddress('#analyse/signals&replay=20260102-030405-3&x=a%26b');
    expect(valueIn(both, 'replay')).toBe('20260102-030405-3');
    expect(formatAddress(both)).toBe('#analyse/signals&replay=20260102-030405-3&x=a%26b');
    expect(formatAddress({ ...both, view: 'drive', tab: '' })).toBe('#drive&replay=20260102-030405-3&x=a%26b');
  });

  it('of a replay shows it, and a wrong one shows the robot', () => {
    expect(parseAddress('#replay=20260102-030405-3').view).toBe('analyse');
    for (const wrong of ['#nothing', '#%E0%A4%A', '#/', '#drivel/x']) expect(parseAddress(wrong).view, wrong).toBe('drive');
  });
});

it('each word with a help is in the glossary, or a plain word', () => {
  const glossary = readFileSync(new URL('../../../daemon/GLOSSARY.md', import.meta.url), 'utf8');
  const plain = ['position', 'yaw', 'pitch', 'track speed', 'battery', 'plan', 'steering'];
  const unknown = Object.keys(kHelp).filter((word) => !plain.includes(word) && !glossary.includes(`| ${word} |`));
  expect(unknown).toEqual([]);
});
