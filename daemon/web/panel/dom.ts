// Small helpers for elements.

type Child = Node | string;

/** An element; `class` and other attributes by name, children in order. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/** A button that does something with each press. */
export function button(attributes: Record<string, string>, content: Child, press: (event: MouseEvent) => void): HTMLButtonElement {
  const element = h('button', { type: 'button', ...attributes }, content);
  element.addEventListener('click', press);
  return element;
}

export function svg<K extends keyof SVGElementTagNameMap>(tag: K, attributes: Record<string, string> = {}): SVGElementTagNameMap[K] {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}

/** A line that tells what was done, or why not. */
export class Message {
  readonly element: HTMLElement;

  constructor(name: string, text = '') {
    this.element = h('p', { class: `message ${name}`, role: 'status' }, text);
  }

  say(text: string, bad = false): void {
    setText(this.element, text);
    setClass(this.element, 'bad', bad);
  }
}

/** Sets the text; touches the page only if it differs. */
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

export function setClass(element: Element, name: string, on: boolean): void {
  if (element.classList.contains(name) !== on) element.classList.toggle(name, on);
}

export function setAttribute(element: Element, name: string, value: string): void {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

/** Lets the browser save a text as a file. */
export function saveText(name: string, text: string): void {
  const url = URL.createObjectURL(new Blob([text], { type: 'text/csv' }));
  h('a', { href: url, download: name }).click();
  setTimeout(() => { URL.revokeObjectURL(url); }, 10_000);
}

/** A button that asks before it deletes: the first press changes its text, the second acts. */
export function deleteButton(attributes: Record<string, string>, act: () => void): HTMLButtonElement {
  const element = button(attributes, 'delete', () => {
    if (element.textContent === 'delete') setText(element, 'really delete');
    else act();
  });
  element.addEventListener('blur', () => { setText(element, 'delete'); });
  return element;
}

/** Whether a text is typed into `target`: then the space bar and all other keys belong to it. */
export function typing(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.matches('input:not([type=range], [type=checkbox]), textarea');
}

/** Whether a person is at this page: it is visible and has the focus. */
export const attended = (): boolean => document.visibilityState === 'visible' && document.hasFocus();

/** Calls `left` when the page loses the focus, is hidden or closed. */
export function onLeave(left: () => void): void {
  for (const gone of ['blur', 'pagehide'] as const) window.addEventListener(gone, left);
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState !== 'visible') left();
  });
}

/** One of a fixed set of symbols, as drawings because fonts lack them. */
export function icon(name: keyof typeof kIcons): SVGSVGElement {
  const image = svg('svg', { class: 'icon', viewBox: '0 0 16 16', 'aria-hidden': 'true' });
  image.append(svg('path', { d: kIcons[name] }));
  return image;
}

const kIcons = {
  play: 'M4 2.5v11l9-5.5z',
  pause: 'M4 3h3v10H4zM9 3h3v10H9z',
  record: 'M8 3.5a4.5 4.5 0 1 0 0 9 4.5 4.5 0 0 0 0-9z',
  wheel: 'M8 1.5a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zm0 2a4.5 4.5 0 0 1 4.3 3.2L9.6 7a1.8 1.8 0 0 0-3.2 0l-2.7-.3A4.5 4.5 0 0 1 8 3.5zM7 12.4A4.5 4.5 0 0 1 3.6 8.7l2.6.4.8 1zm2 0v-2.3l.8-1 2.6-.4A4.5 4.5 0 0 1 9 12.4z',
  theme: 'M8 1.5a6.5 6.5 0 1 0 0 13a6.5 6.5 0 1 0 0-13zM8 3.2v9.6a4.8 4.8 0 0 1 0-9.6z',
  grid: 'M2 2h5v5H2zM9 2h5v5H9zM2 9h5v5H2zM9 9h5v5H9z',
  fold: 'M5 3l1.5-1.5L13 8l-6.5 6.5L5 13l5-5z',
  square: 'M4 4h8v8H4z',
  mark: 'M4 1.5h1.5V3H13l-2 3 2 3H5.5v5.5H4z',
  close: 'M4 5l1-1 3 3 3-3 1 1-3 3 3 3-1 1-3-3-3 3-1-1 3-3z',
  stop: 'M5.3 1.5h5.4l3.8 3.8v5.4l-3.8 3.8H5.3l-3.8-3.8V5.3z',
};

/** Periodic work, done when the browser draws a frame. */
export interface Task {
  /** Least time between two runs; 0: at every frame. */
  period_ms: number;
  run(now_ms: number): void;
}

/** Runs the tasks from the next frame on, in this order, as long as the page exists. */
export function everyFrame(tasks: readonly Task[]): void {
  const due_ms = tasks.map(() => 0);
  const frame = (now_ms: number): void => {
    tasks.forEach((task, i) => {
      if (now_ms < (due_ms[i] ?? 0)) return;
      due_ms[i] = now_ms + task.period_ms;
      task.run(now_ms);
    });
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}
