// The colours of the current theme for drawing by scripts. page/theme.css defines them as custom properties.
export type Colour =
  | 'path' | 'model' | 'odometry' | 'fused' | 'truth' | 'left' | 'right' | 'value' | 'run-2' | 'run-3' | 'run-5'
  | 'text' | 'dim' | 'warn' | 'bad' | 'panel' | 'axis-grid'
  | 'sky' | 'floor' | 'grid' | 'grid-bold' | 'fence' | 'keep-out' | 'obstacle' | 'obstacle-edge' | 'surface';

const read = new Map<Colour, string>();

export function colour(name: Colour): string {
  let value = read.get(name);
  if (value === undefined) {
    value = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
    read.set(name, value);
  }
  return value;
}

/** Call when the theme has changed. */
export function forgetColours(): void {
  read.clear();
}
