// Driving by hand: the button that takes the lease, and while this page drives the stick, the
// commanded and the actual motion.
import type { Driver } from '../drive/driver.ts';
import type { Inputs } from '../drive/inputs.ts';
import { Confirmation, type Consent } from '../state/consent.ts';
import { degrees, fixed } from '../state/format.ts';
import { kNoRights, type State } from '../state/messages.ts';
import type { Store } from '../state/store.ts';
import { control } from './controls.ts';
import { button, h, setAttribute, setClass, setText } from './dom.ts';

const kSources = { none: 'no control held', keys: 'keys', stick: 'stick', gamepad: 'gamepad' };

export class DrivePanel {
  private readonly control = control('by-hand', 'wheel', 'By hand', 't', () => { this.press(); });
  readonly button = this.control.button;
  readonly element = h('section', { class: 'drive-panel', 'aria-label': 'Driving by hand', hidden: '' });
  private readonly stick: Stick;
  private readonly source = h('p', { class: 'drive-source', role: 'status' });
  private readonly speed = h('dd', { id: 'drive-speed' });
  private readonly turn = h('dd', { id: 'drive-turn' });
  private readonly share = h('input', { type: 'range', id: 'drive-share', min: '10', max: '100', step: '5', value: '50', 'aria-label': 'Greatest speed' });
  private readonly shareText = h('output', { for: 'drive-share' });
  private readonly asked = h('p', { class: 'drive-asked', role: 'status' });
  private readonly release = button({ class: 'control', id: 'drive-release' }, 'Release', () => { this.driver.release(); });
  private readonly confirmation: Confirmation;
  /** It waits for the second press. */
  asks = false;
  private needsConfirmation = true;

  constructor(
    private readonly driver: Driver,
    private readonly inputs: Inputs,
    consent: Consent,
    /** The robot is asked to move. */
    private readonly moves: () => void,
  ) {
    this.confirmation = new Confirmation(consent);
    this.stick = new Stick((at) => {
      inputs.touch(at);
      driver.tick();
    });
    this.share.addEventListener('input', () => {
      driver.share = this.share.valueAsNumber / 100;
    });
    this.element.append(
      this.stick.element,
      h(
        'div',
        { class: 'drive-text' },
        this.source,
        h('dl', { class: 'drive-facts' }, h('dt', {}, 'speed'), this.speed, h('dt', {}, 'turn'), this.turn),
        h('label', { class: 'drive-limit', for: 'drive-share' }, 'at most ', this.shareText),
        this.share,
        this.asked,
      ),
      this.release,
    );
  }

  /** Takes the lease, confirmed if the daemon requires it. Never releases it: a control that starts never stops. */
  press(): void {
    if (this.button.disabled || this.driver.drives) return;
    if (this.needsConfirmation && !this.confirmation.press()) return;
    void this.driver.take();
    this.moves();
  }

  show(store: Store, connected: boolean, mayCommand: boolean): void {
    const state = store.get('/state');
    const fresh = connected && mayCommand && state !== undefined && !store.stale('/state');
    this.showButton(state, fresh, mayCommand);
    const drives = this.driver.drives;
    if (this.element.hidden === drives) this.element.hidden = !drives;
    if (!drives) {
      this.stick.letGo();
      return;
    }
    const parameters = store.get('/parameter')?.parameters ?? [];
    const number = (name: string, otherwise: number): number => {
      const value = parameters.find((parameter) => parameter.name === name)?.value;
      return typeof value === 'number' ? value : otherwise;
    };
    this.driver.limits = {
      speed_mps: number('robot.drive.max_track_mps', 0.2),
      yaw_rate_radps: number('robot.drive.max_yaw_radps', 1),
    };
    this.showDrive(store, state);
  }

  private showButton(state: State | undefined, fresh: boolean, mayCommand: boolean): void {
    this.needsConfirmation = state?.confirm_start !== false;
    // Another driver can be asked for the lease.
    const other = state?.driver?.fresh === true && !this.driver.drives;
    this.button.disabled = !(fresh && !this.driver.drives && (state?.can.drive === true || other));
    // Pause has this place during a run.
    this.button.hidden = state?.can.pause === true;
    const confirm = (this.asks = this.confirmation.show());
    setClass(this.button, 'confirm', confirm);
    setText(this.control.label, confirm ? 'Press again' : other ? 'Ask' : 'By hand');
    const why = !mayCommand ? kNoRights : (state?.why_not_drive ?? '');
    const title = other ? `${why}: ask for the lease, the right to drive` : why;
    setAttribute(this.button, 'title', title === '' ? 'Drive by hand, with keys, stick or gamepad (m)' : title);
  }

  private showDrive(store: Store, state: State | undefined): void {
    const wish = this.driver.wish;
    const estimate = store.get('/estimate');
    const pose = estimate?.[estimate.steering];
    const armed = state?.run === 'driving';
    setClass(this.element, 'frozen', this.inputs.frozen || estimate?.at_fence === true);
    const source = this.inputs.frozen
      ? 'gamepad: its values do not change; move the stick'
      : this.inputs.silent
        ? 'keys: the keyboard does not repeat them; press again'
        : !armed
          ? 'arming\u2026'
          : estimate?.at_fence === true
            ? 'at the fence: drive away from it'
            : kSources[wish?.source ?? 'none'];
    setText(this.source, source);
    const { speed_mps, yaw_rate_radps } = this.driver.limits;
    setText(this.speed, `${fixed(pose?.vx_mps, 3)} m/s, commanded ${fixed(estimate?.desired_speed_mps, 3)}`);
    setText(this.turn, `${degrees(pose?.yaw_rate_radps, 0)}\u00b0/s, wanted ${degrees((wish?.left ?? 0) * this.driver.share * yaw_rate_radps, 0)}`);
    const most = this.driver.share * speed_mps;
    setText(this.shareText, `${fixed(most, 2)} of ${fixed(speed_mps, 2)} m/s, ${degrees(this.driver.share * yaw_rate_radps, 0)}\u00b0/s`);
    const by = state?.driver?.asked_by ?? '';
    setText(this.asked, by === '' ? '' : `${by} asks for the lease: release it?`);
    this.stick.show(wish?.forward ?? 0, wish?.left ?? 0);
  }
}

/** A stick for finger or mouse. It springs back when released. */
class Stick {
  readonly element = h('div', { class: 'drive-stick', 'aria-hidden': 'true' });
  private readonly knob = h('div', { class: 'drive-knob' });
  private pointer: number | undefined;

  constructor(private readonly moved: (at: { forward: number; left: number } | undefined) => void) {
    this.element.append(this.knob);
    this.element.addEventListener('pointerdown', (event) => {
      if (this.pointer !== undefined || event.button !== 0) return;
      event.preventDefault();
      this.pointer = event.pointerId;
      this.element.setPointerCapture(event.pointerId);
      this.move(event);
    });
    this.element.addEventListener('pointermove', (event) => {
      if (event.pointerId !== this.pointer) return;
      // The release may get lost, as that of a key.
      if (event.buttons === 0) this.letGo();
      else this.move(event);
    });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
      this.element.addEventListener(end, (event) => {
        if (event.pointerId === this.pointer) this.letGo();
      });
  }

  letGo(): void {
    if (this.pointer === undefined) return;
    this.pointer = undefined;
    this.moved(undefined);
  }

  show(forward: number, left: number): void {
    this.knob.style.transform = `translate(${(-75 * left).toFixed(1)}%, ${(-75 * forward).toFixed(1)}%)`;
  }

  private move(event: PointerEvent): void {
    const box = this.element.getBoundingClientRect();
    const radius = box.width / 2;
    const x = (event.clientX - box.left - radius) / radius;
    const y = (event.clientY - box.top - radius) / radius;
    const size = Math.max(1, Math.hypot(x, y));
    const quiet = (value: number): number => (Math.abs(value) < 0.08 ? 0 : value);
    this.moved({ forward: quiet(-y / size), left: quiet(-x / size) });
  }
}
