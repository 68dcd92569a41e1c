// A daemon that a test operates directly: the sockets that a page opens, and what is said over them.
import type { Socket } from '../../../daemon/web/foxglove/connection.ts';

export class FakeSocket implements Socket {
  onopen: Socket['onopen'] = null;
  onclose: Socket['onclose'] = null;
  onmessage: Socket['onmessage'] = null;
  readonly sent: (string | ArrayBuffer)[] = [];
  closed = false;

  send(data: string | ArrayBufferLike | Blob | ArrayBufferView): void {
    this.sent.push(data as string | ArrayBuffer);
  }

  close(): void {
    this.closed = true;
  }

  open(): void {
    this.onopen?.call(this as unknown as WebSocket, new Event('open'));
  }

  die(): void {
    this.onclose?.call(this as unknown as WebSocket, new Event('close') as CloseEvent);
  }

  say(data: unknown): void {
    this.onmessage?.call(this as unknown as WebSocket, { data } as MessageEvent);
  }

  json(message: unknown): void {
    this.say(JSON.stringify(message));
  }

  /** Opens it as a daemon with channels `/state` and `/link` and services `stop` and `start`, numbered from `first` on. */
  greet(sessionId = 's', first = 1): void {
    this.open();
    this.json({ op: 'serverInfo', name: 'tp100d', sessionId, capabilities: [], metadata: { name: 'left' } });
    this.json({ op: 'advertise', channels: [{ id: first, topic: '/state' }, { id: first + 1, topic: '/link' }] });
    this.json({ op: 'advertiseServices', services: [{ id: first, name: 'stop' }, { id: first + 1, name: 'start' }] });
  }

  /** Service calls that were sent: binary frames. */
  get calls(): ArrayBuffer[] {
    return this.sent.filter((frame) => frame instanceof ArrayBuffer);
  }
}

/** Every socket that was opened. */
export class FakeDaemon {
  readonly sockets: FakeSocket[] = [];
  readonly make = (): FakeSocket => {
    const socket = new FakeSocket();
    this.sockets.push(socket);
    return socket;
  };

  at(index: number): FakeSocket {
    return this.sockets.at(index) ?? new FakeSocket();
  }

  get newest(): FakeSocket {
    return this.at(-1);
  }
}

function frame(head: number, content: string, fill: (view: DataView) => void): ArrayBuffer {
  const bytes = new TextEncoder().encode(content);
  const view = new DataView(new ArrayBuffer(13 + bytes.length));
  view.setUint8(0, head);
  fill(view);
  new Uint8Array(view.buffer, 13).set(bytes);
  return view.buffer;
}

/** A message of a subscription. */
export const message = (subscription: number, content: unknown): ArrayBuffer =>
  frame(1, JSON.stringify(content), (view) => {
    view.setUint32(1, subscription, true);
  });

/** The answer to a call. */
export const answer = (call: number, content: unknown): ArrayBuffer =>
  frame(3, `json${JSON.stringify(content)}`, (view) => {
    view.setUint32(5, call, true);
    view.setUint32(9, 4, true);
  });
