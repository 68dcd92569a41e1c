// What the daemon said before this page was opened.
const asked = new Map<string, Promise<readonly unknown[]>>();

/** The last minutes of a topic, oldest first, as /api/history has them; empty if it has none. */
export function past(topic: string): Promise<readonly unknown[]> {
  const known = asked.get(topic) ?? fetch(`/api/history${topic}`).then((answer) => (answer.ok ? (answer.json() as Promise<unknown[]>) : []));
  asked.set(topic, known);
  // Later it is the present that was missed.
  setTimeout(() => asked.delete(topic), 1000);
  return known;
}
