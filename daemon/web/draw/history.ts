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

  get text(): string {
    return this.texts[this.at] ?? '';
  }

  get canUndo(): boolean {
    return this.at > 0;
  }

  get canRedo(): boolean {
    return this.at + 1 < this.texts.length;
  }

  undo(): string {
    if (this.canUndo) this.at--;
    return this.text;
  }

  redo(): string {
    if (this.canRedo) this.at++;
    return this.text;
  }
}
