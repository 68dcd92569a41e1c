// The view of the course in words: read out when the state changes, and kept up to date quietly.
import { sceneKey, sceneText } from '../state/scene_text.ts';
import type { Store } from '../state/store.ts';
import { h, setText } from './dom.ts';

/** Figures change all the time; nobody wants to listen to all of them. */
const kPeriod_ms = 10_000;

export class SceneWords {
  readonly element = h('p', { class: 'for-reading', id: 'scene-words', role: 'status' });
  private key = '';
  private next_ms = -Infinity;

  show(store: Store, replayed: boolean, now_ms: number): void {
    const key = `${String(replayed)} ${sceneKey(store)}`;
    if (key === this.key && now_ms < this.next_ms) return;
    this.key = key;
    this.next_ms = now_ms + kPeriod_ms;
    setText(this.element, sceneText(store, replayed));
  }
}
