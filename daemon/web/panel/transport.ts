// The bar of a displayed recording: play, scrub, speed, close.
import type { Player } from '../replay/player.ts';
import { clock } from '../state/format.ts';
import { button, h, icon, setAttribute, setText } from './dom.ts';

const kSpeeds = [1, 2, 4, 0.25];
const kStep_s = 0.1;

export class Transport {
  readonly element = h('section', { class: 'transport', 'aria-label': 'Recording' });
  private readonly name = h('span', { class: 'transport-name' });
  private readonly play = button({ id: 'play', 'aria-label': 'Play' }, '', () => this.player?.toggle());
  private readonly slider = h('input', { type: 'range', id: 'scrub', min: '0', step: '0.01', list: 'marks', 'aria-label': 'Position in the recording, seconds' });
  private readonly ticks = h('datalist', { id: 'marks' });
  private readonly markButton: HTMLButtonElement;
  private readonly time = h('output', { class: 'transport-time' });
  private readonly speed = button({ 'aria-label': 'Speed' }, '1\u00d7', () => {
    if (this.player === undefined) return;
    this.player.speed = kSpeeds[(kSpeeds.indexOf(this.player.speed) + 1) % kSpeeds.length] ?? 1;
    setText(this.speed, `${this.player.speed}\u00d7`);
  });
  private player: Player | undefined;
  private shownPlaying: boolean | undefined;

  constructor(close: () => void, mark: () => void) {
    const leave = button({ id: 'live' }, 'close', close);
    this.markButton = button({ id: 'mark-replay', title: 'Mark this moment (m)', 'aria-label': 'Mark this moment' }, icon('mark'), mark);
    this.element.append(this.name, this.play, this.slider, this.ticks, this.time, this.markButton, this.speed, leave);
    this.element.hidden = true;
    this.slider.addEventListener('input', () => {
      if (this.player === undefined) return;
      this.player.playing = false;
      this.player.show(Number(this.slider.value));
    });
  }

  loading(run: string, share: number): void {
    this.element.hidden = false;
    setText(this.name, `${run} \u00b7 loading ${(100 * share).toFixed(0)} %`);
  }

  open(run: string, player: Player): void {
    this.player = player;
    this.element.hidden = false;
    this.slider.max = player.duration_s.toFixed(2);
    setText(this.speed, '1\u00d7');
    setText(this.name, run);
    this.showMarks(player);
  }

  /** Marks this moment of the recording. */
  pressMark(): void {
    this.markButton.click();
  }

  /** The marks as ticks of the slider. */
  showMarks(player: Player): void {
    this.ticks.replaceChildren(...player.marks.map(({ position_s, text }) => h('option', { value: position_s.toFixed(2), label: text })));
  }

  close(): void {
    this.player = undefined;
    this.element.hidden = true;
  }

  step(direction: 1 | -1): void {
    if (this.player === undefined) return;
    this.player.playing = false;
    this.player.show(this.player.position_s + direction * kStep_s);
  }

  show(): void {
    const player = this.player;
    if (player === undefined) return;
    const value = player.position_s.toFixed(2);
    if (this.slider.value !== value) this.slider.value = value;
    setText(this.time, `${clock(player.position_s)} / ${clock(player.duration_s)}`);
    if (player.playing === this.shownPlaying) return;
    this.shownPlaying = player.playing;
    this.play.replaceChildren(icon(player.playing ? 'pause' : 'play'));
    setAttribute(this.play, 'aria-label', player.playing ? 'Pause' : 'Play');
  }
}
