// The two checkboxes for notifications and sound, and their implementation in the browser.
import { Alerts, type Outlets } from '../state/alerts.ts';
import { h } from './dom.ts';

const kTones_hz = [880, 660];
const kTone_s = 0.22;

class BrowserOutlets implements Outlets {
  private audio: AudioContext | undefined;

  notify(title: string, text: string): void {
    if (!('Notification' in window) || Notification.permission !== 'granted') return;
    try {
      new Notification(`TP100: ${title}`, { body: text, tag: 'tp100' });
    } catch {
      // Browsers on phones allow it only to service workers.
    }
  }

  beep(): void {
    this.audio ??= new AudioContext();
    const audio = this.audio;
    void audio.resume();
    kTones_hz.forEach((tone_hz, i) => {
      const tone = audio.createOscillator();
      const volume = audio.createGain();
      tone.frequency.value = tone_hz;
      volume.gain.value = 0.2;
      tone.connect(volume).connect(audio.destination);
      tone.start(audio.currentTime + i * kTone_s);
      tone.stop(audio.currentTime + (i + 1) * kTone_s);
    });
  }
}

export class AlertChoice {
  readonly alerts: Alerts;
  readonly elements: HTMLElement[];

  constructor(say: (text: string) => void) {
    const outlets = new BrowserOutlets();
    this.alerts = new Alerts(outlets, localStorage);
    const sound = box('alert-sound', 'sound', this.alerts.sounds);
    sound.input.addEventListener('change', () => {
      this.alerts.sounds = sound.input.checked;
      // Also proves to the browser that the user wants sound.
      if (sound.input.checked) outlets.beep();
    });
    const notify = box('alert-notify', 'notify', this.alerts.notifies && 'Notification' in window);
    notify.input.disabled = !('Notification' in window);
    if (notify.input.disabled) notify.element.title = 'This browser permits notifications only on encrypted pages';
    notify.input.addEventListener('change', () => {
      this.alerts.notifies = notify.input.checked;
      if (!notify.input.checked) return;
      void Notification.requestPermission().then((permission) => {
        if (permission === 'granted') return;
        notify.input.checked = this.alerts.notifies = false;
        say('The browser does not permit notifications of this page; change it in its settings');
      });
    });
    this.elements = [h('span', {}, 'on faults:'), notify.element, sound.element];
  }
}

function box(id: string, text: string, checked: boolean): { element: HTMLElement; input: HTMLInputElement } {
  const input = h('input', { type: 'checkbox', id, 'aria-label': `On faults: ${text}` });
  input.checked = checked;
  return { element: h('label', {}, input, text), input };
}
