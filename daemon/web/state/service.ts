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

const asked = new Map<string, Promise<readonly unknown[]>>();

/** The last minutes of a topic, oldest first, as /api/history has them; empty if it has none. */
export function past(topic: string): Promise<readonly unknown[]> {
  const known = asked.get(topic) ?? fetch(`/api/history${topic}`).then((answer) => (answer.ok ? (answer.json() as Promise<unknown[]>) : []));
  asked.set(topic, known);
  // Cached only for requests at the same time: a later one also needs what came in between.
  setTimeout(() => asked.delete(topic), 1000);
  return known;
}
