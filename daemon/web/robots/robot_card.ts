// A robot's card: state, figures, faults, the link to its page, and its STOP.
import { thumbnail } from '../panel/course_card.ts';
import { h, setAttribute, setText, svg } from '../panel/dom.ts';
import { StopPanel } from '../panel/stop_panel.ts';
import { timeLeft_s } from '../panel/timeline.ts';
import { clock, degrees, fixed } from '../state/format.ts';
import type { Course, State } from '../state/messages.ts';
import { minutes, runWords } from '../state/run_words.ts';
import type { Robot } from './robot.ts';

export class RobotCard {
  readonly element: HTMLElement;
  private readonly name = h('h2', {});
  private readonly badge = h('span', { class: 'badge' });
  private readonly status = h('p', { class: 'card-status', role: 'status' });
  private readonly problem = h('p', { class: 'card-problem' });
  private readonly figure = { robot: h('dd'), course: h('dd'), time: h('dd'), pose: h('dd'), battery: h('dd') };
  private readonly figures = h('dl', { class: 'card-figures' }, ...Object.entries(this.figure).map(([name, value]) => h('div', {}, h('dt', {}, name), value)));
  private readonly map = h('div', { class: 'card-map' });
  private readonly marker = svg('polygon', { points: '0.12,0 -0.08,0.07 -0.08,-0.07', fill: 'var(--text)' });
  private course: Course | undefined;
  private readonly stop: StopPanel;

  constructor(private readonly robot: Robot) {
    const { url } = robot.listed;
    const { host } = new URL(url);
    this.stop = new StopPanel(() => { this.pressStop(); }, () => '');
    const page = h('a', { class: 'link', href: url }, host);
    this.element = h(
      'li',
      { class: 'card', 'data-lamp': 'none', 'data-url': url },
      h('div', { class: 'card-head' }, this.name, this.badge),
      this.status,
      this.map,
      this.figures,
      this.problem,
      h('p', { class: 'card-page' }, page, robot.listed.own === true ? ' serves this page' : ''),
      this.stop.element,
    );
  }

  pressStop(): void {
    this.robot.stop.press(performance.now());
  }

  show(ended: boolean): void {
    const { robot } = this;
    const { state, contact } = robot;
    const name = robot.name || new URL(robot.listed.url).host;
    setText(this.name, name);
    setAttribute(this.stop.element, 'aria-label', `STOP ${name}`);
    setAttribute(this.element, 'data-contact', contact);
    this.stop.show(robot.stop.button.view(performance.now()));
    const answers = contact === 'answers' && state !== undefined;
    this.figures.hidden = this.badge.hidden = this.map.hidden = !answers;
    if (answers) this.showState(state);
    else this.showSilence(ended);
  }

  private showState(state: State): void {
    const present = state.session === 'ready';
    const { lamp, word, detail } = runWords(state);
    setAttribute(this.element, 'data-lamp', lamp);
    setText(this.status, state.run === 'running' && state.pause_left_s === undefined ? word : [word, detail].filter((text) => text !== '').join(' \u00b7 '));
    setText(this.badge, this.robot.link?.kind ?? '');
    setAttribute(this.badge, 'data-kind', this.robot.link?.kind ?? '');
    setText(this.figure.robot, `${state.robot} \u00b7 ${state.setup}`);
    const progress = typeof state.length_m === 'number' ? `, ${fixed(state.progress_m, 2)} of ${fixed(state.length_m, 2)} m` : '';
    setText(this.figure.course, state.course === '' ? 'none' : `${state.course}${progress}`);
    const { course } = this.robot;
    const left = course !== undefined && state.run === 'running' && state.pause_left_s === undefined ? `, ${minutes(timeLeft_s(course, state.progress_m))} left` : '';
    setText(this.figure.time, typeof state.run_s === 'number' ? clock(state.run_s) + left : '\u2013');
    const { pose } = state;
    this.draw(course, pose);
    setText(this.figure.pose, pose ? `x ${fixed(pose.x_m, 2)} m, y ${fixed(pose.y_m, 2)} m, ${degrees(pose.yaw_rad, 0)}\u00b0` : '\u2013');
    setText(this.figure.battery, typeof state.battery_v === 'number' && present ? `${fixed(state.battery_v, 1)} V` : '\u2013');
    const [fault] = state.faults;
    const more = state.faults.length > 1 ? ` (+${state.faults.length - 1})` : '';
    setText(this.problem, fault === undefined ? (present ? '' : this.robot.link?.note ?? '') : fault.cause + more);
  }

  /** The course, and the robot on it. */
  private draw(course: Course | undefined, pose: State['pose']): void {
    if (course !== this.course) {
      this.course = course;
      this.map.replaceChildren(...(course === undefined || course.path.length === 0 ? [] : [thumbnail({ name: course.name, start: course.start, outline: course.path })]));
      this.map.firstElementChild?.append(this.marker);
    }
    if (pose) setAttribute(this.marker, 'transform', `translate(${pose.x_m} ${-pose.y_m}) rotate(${(-pose.yaw_rad * 180) / Math.PI})`);
  }

  /** Without contact, hides everything that may have changed since. */
  private showSilence(ended: boolean): void {
    const { contact, listed } = this.robot;
    setAttribute(this.element, 'data-lamp', contact === 'connecting' ? 'wait' : 'bad');
    setText(this.status, contact === 'connecting' ? 'connecting' : contact === 'other' ? 'another daemon' : ended ? 'ended' : 'no answer');
    const named = `is it reachable from here, and is ${location.origin} in its server.origins?`;
    const found = 'its daemon hangs, or this address does not lead to it from here';
    const problem = {
      connecting: '',
      answers: '',
      other: 'This address leads to a daemon that is not the listed one.',
      no_answer: ended ? 'Its daemon has ended.' : `Nothing is known of the robot now: ${listed.session === undefined ? named : found}`,
    }[contact];
    setText(this.problem, problem);
  }
}
