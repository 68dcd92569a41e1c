// A simple viewer of the daemon that provides the published messages, with which tests compare the page.
import { WebSocket } from 'ws';
import { parseBinary, parseText, subscribe } from '../../../daemon/web/foxglove/codec.ts';
import type { Channels, Topic } from '../../../daemon/web/state/messages.ts';

export class Bus {
  readonly received: { [T in Topic]?: Channels[T][] } = {};
  private readonly socket: WebSocket;

  constructor(url: string, topics: Topic[]) {
    this.socket = new WebSocket(url.replace(/^http/, 'ws'), ['foxglove.sdk.v1']);
    this.socket.binaryType = 'arraybuffer';
    const names = new Map<number, Topic>();
    this.socket.on('message', (data, binary) => {
      if (!binary) {
        const message = parseText(Buffer.from(data as ArrayBuffer).toString());
        if (message?.op !== 'advertise') return;
        const wanted = message.channels.filter((channel) => topics.includes(channel.topic as Topic));
        for (const { id, topic } of wanted) names.set(id, topic as Topic);
        this.socket.send(subscribe(wanted.map(({ id }) => ({ id, channelId: id }))));
        return;
      }
      const message = parseBinary(data as ArrayBuffer);
      if (message?.op !== 'message') return;
      const topic = names.get(message.subscriptionId);
      if (topic === undefined) return;
      const list = (this.received[topic] ??= []) as unknown[];
      list.push(JSON.parse(new TextDecoder().decode(message.payload)));
    });
    this.socket.on('error', () => undefined);
  }

  last<T extends Topic>(topic: T): Channels[T] | undefined {
    return this.received[topic]?.at(-1);
  }

  close(): void {
    this.socket.close();
  }
}
