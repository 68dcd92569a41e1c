// The camera image beside the view of the course: the newest one taken before the time shown.
import type { Store } from '../state/store.ts';
import { button, h, setAttribute, setClass, setText } from './dom.ts';

/** Above this age an image is grey. */
const kOld_s = 2;

export class CameraImagePanel {
  readonly element = h('figure', { class: 'camera-image' });
  private readonly image = h('img', { alt: 'Image of the camera', decoding: 'sync' });
  private readonly age = h('span', { class: 'camera-age' });
  private readonly hide = button({ id: 'camera-image-toggle', 'aria-expanded': 'true' }, 'hide', () => {
    this.open = !this.open;
    setAttribute(this.hide, 'aria-expanded', String(this.open));
    setText(this.hide, this.open ? 'hide' : 'show');
    this.received = -1;
  });
  private received = -1;
  private open = true;

  constructor() {
    this.element.append(this.image, h('figcaption', {}, 'camera', this.age, this.hide));
    this.element.hidden = true;
  }

  /** `began_unix_s`: the Unix time of t_s = 0. */
  show(store: Store, began_unix_s: number | undefined): void {
    const message = store.get('/camera/image');
    const there = message?.format === 'jpeg';
    this.element.hidden = !there;
    setClass(document.body, 'with-image', there && this.open);
    if (!there) {
      this.received = -1;
      return;
    }
    const taken_s = message.timestamp.sec + message.timestamp.nsec * 1e-9 - (began_unix_s ?? NaN);
    const age_s = (store.get('/estimate')?.t_s ?? NaN) - taken_s;
    setClass(this.element, 'stale', store.stale('/camera/image') || !(age_s < kOld_s));
    setText(this.age, Number.isFinite(age_s) ? `${Math.max(age_s, 0).toFixed(1)} s ago` : '');
    const received = store.received['/camera/image'] ?? 0;
    if (!this.open || received === this.received) return;
    this.received = received;
    this.image.src = `data:image/jpeg;base64,${message.data}`;
    setAttribute(this.element, 'data-t_s', taken_s.toFixed(3));
  }
}
