// Undo history of a text: one state for each finished change.
const kMaxStates = 200;

export class History {
  private texts: string[] = [''];
  private at = 0;

  /** Begins anew with another file. */
  restart(text: string): void {
    this.texts = [text];
    this.at = 0;
  }

  /** Adds the state after a finished change. */
  add(text: string): void {
    if (text === this.text) return;
    this.texts = [...this.texts.slice(0, this.at + 1), text].slice(-kMaxStates);
    this.at = this.texts.length - 1;
  }

  /** Whether there is a state before, -1, or after the present one, 1. */
  can(step: 1 | -1): boolean {
    return this.texts[this.at + step] !== undefined;
  }

  /** The state before or after, which becomes the present one; without one, the present one. */
  go(step: 1 | -1): string {
    if (this.can(step)) this.at += step;
    return this.text;
  }

  private get text(): string {
    return this.texts[this.at] ?? '';
  }
}
