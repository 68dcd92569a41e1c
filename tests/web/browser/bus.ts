// A viewer of the daemon that provides the published messages, with which tests compare the page.
import { WebSocket } from 'ws';
import { Client } from '../../../daemon/web/foxglove/client.ts';
import { kSubprotocols } from '../../../daemon/web/foxglove/codec.ts';
import type { Socket } from '../../../daemon/web/foxglove/connection.ts';
import type { Channels, Topic } from '../../../daemon/web/state/messages.ts';

export class Bus {
  readonly received: { [T in Topic]?: Channels[T][] } = {};
  private readonly client: Client;

  constructor(url: string, topics: Topic[]) {
    const make = (): Socket => {
      const socket = new WebSocket(url.replace(/^http/, 'ws'), kSubprotocols);
      socket.binaryType = 'arraybuffer';
      socket.on('error', () => undefined);
      return socket as unknown as Socket;
    };
    this.client = new Client(make, { serverInfo: () => undefined, ready: () => undefined, closed: () => undefined });
    for (const topic of topics) this.client.subscribe(topic, (message) => ((this.received[topic] ??= []) as unknown[]).push(message));
  }

  last<T extends Topic>(topic: T): Channels[T] | undefined {
    return this.received[topic]?.at(-1);
  }

  close(): void {
    this.client.end();
  }
}
