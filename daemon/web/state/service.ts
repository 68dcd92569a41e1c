// Requests to the daemon: services, and the messages of a topic from before the page was opened.

/** Rejects with an Error if the daemon refuses or the connection is lost. */
export type Call = (service: string, request: unknown) => Promise<unknown>;

/** Why a call failed, in one line. */
export const reason = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** The text of an answer of the daemon; rejects if it has none. */
export async function fetched(path: string): Promise<string> {
  const answer = await fetch(path, { cache: 'no-store' });
  if (!answer.ok) throw new Error(`${path}: ${answer.statusText}`);
  return answer.text();
}

const kRefresh_ms = 5000;

/** A list of the daemon that is fetched every few seconds while it is shown, and given on when it has changed. */
export class Listing<T> {
  private text = '';
  private next_ms = 0;

  constructor(
    private readonly path: string,
    private readonly take: (list: T) => void,
    private readonly failed: () => void,
  ) {}

  /** Call while the list is shown. */
  show(): void {
    if (performance.now() < this.next_ms) return;
    this.next_ms = performance.now() + kRefresh_ms;
    void this.load();
  }

  /** Fetches the list at once, and gives it on also if it is the same. */
  reload(): void {
    this.text = '';
    this.next_ms = 0;
  }

  private async load(): Promise<void> {
    try {
      const text = await fetched(this.path);
      if (text === this.text) return;
      this.text = text;
      this.take(JSON.parse(text) as T);
    } catch {
      this.text = '';
      this.failed();
    }
  }
}

const asked = new Map<string, Promise<readonly unknown[]>>();

/** The last minutes of a topic, or its last seconds, oldest first, as /api/history has them; empty if it has none. */
export function past(topic: string, span_s?: number): Promise<readonly unknown[]> {
  const path = `/api/history${topic}${span_s === undefined ? '' : `?span_s=${span_s}`}`;
  const known = asked.get(path) ?? fetch(path).then((answer) => (answer.ok ? (answer.json() as Promise<unknown[]>) : []));
  asked.set(path, known);
  // Cached only for requests at the same time: a later one also needs what came in between.
  setTimeout(() => asked.delete(path), 1000);
  return known;
}
