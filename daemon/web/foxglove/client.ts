// A viewer of one server: topics and services by name, independent of a server's ids and of
// reconnections.
import * as codec from './codec.ts';
import { Connection, type Socket } from './connection.ts';

export type Listener = (message: unknown) => void;

export interface ServerInfo {
  sessionId: string;
  metadata: Record<string, string>;
}

export interface ClientEvents {
  /** The server sent its identity. */
  serverInfo(info: ServerInfo): void;
  /** The services are known. Called before any other request, so that requests made here are sent first. */
  ready(): void;
  closed(retry_ms: number): void;
  status?(level: number, message: string): void;
}

interface Call {
  resolve(response: unknown): void;
  reject(error: Error): void;
}

export class Client {
  private readonly connection: Connection;
  private readonly listeners = new Map<string, { listener: Listener; interval_ms: number }>();
  private readonly channels = new Map<string, number>();
  private readonly services = new Map<string, number>();
  private readonly subscriptions = new Map<number, Listener>();
  private readonly subscribed = new Map<string, number>();
  private readonly calls = new Map<number, Call>();
  private readonly decoder = new TextDecoder();
  private isReady = false;
  private nextSubscription = 1;
  private nextCall = 1;

  constructor(
    make: () => Socket,
    private readonly events: ClientEvents,
    now?: () => number,
  ) {
    this.connection = new Connection(
      make,
      {
        closed: (retry_ms) => {
          this.forget();
          events.closed(retry_ms);
        },
        text: (frame) => {
          this.text(frame);
        },
        binary: (frame) => {
          this.binary(frame);
        },
      },
      now,
    );
  }

  /** True from the moment the server's services are known until the connection ends. */
  get ready(): boolean {
    return this.isReady && this.connection.connected;
  }

  /** Messages of `topic` from now on, across reconnections, at most one in each interval; 0: all. One listener per topic. */
  subscribe(topic: string, listener: Listener, interval_ms = 0): void {
    if (this.listeners.get(topic)?.interval_ms === interval_ms) return;
    this.unsubscribe(topic);
    this.listeners.set(topic, { listener, interval_ms });
    this.subscribeNow([topic]);
  }

  unsubscribe(topic: string): void {
    this.listeners.delete(topic);
    const id = this.subscribed.get(topic);
    if (id === undefined) return;
    this.subscribed.delete(topic);
    this.subscriptions.delete(id);
    this.connection.send(JSON.stringify({ op: 'unsubscribe', subscriptionIds: [id] }));
  }

  /** Rejects if there is no server, it has no such service, it refuses, or the connection ends first. */
  call(name: string, request: unknown = {}): Promise<unknown> {
    const service = this.services.get(name);
    if (!this.ready) return Promise.reject(new Error('not connected'));
    if (service === undefined) return Promise.reject(new Error(`the server has no service "${name}"`));
    const id = this.nextCall++;
    return new Promise((resolve, reject) => {
      this.calls.set(id, { resolve, reject });
      this.connection.send(codec.callService(service, id, request));
    });
  }

  setParameter(name: string, value: number | boolean | string): void {
    this.connection.send(JSON.stringify({ op: 'setParameters', parameters: [{ name, value }] }));
  }

  retryNow(): void {
    this.connection.retryNow();
  }

  /** Ends the connection for good. */
  end(): void {
    this.connection.end();
  }

  private text(frame: string): void {
    const message = codec.parseText(frame);
    switch (message.op) {
      case 'serverInfo':
        this.events.serverInfo({ sessionId: codec.text(message.sessionId), metadata: codec.texts(message.metadata) });
        break;
      case 'advertise':
        for (const [topic, id] of codec.ids(message.channels, 'topic')) this.channels.set(topic, id);
        if (this.isReady) this.subscribeNow([...this.listeners.keys()]);
        break;
      case 'advertiseServices':
        for (const [name, id] of codec.ids(message.services, 'name')) this.services.set(name, id);
        if (this.isReady) break;
        this.isReady = true;
        this.events.ready();
        this.subscribeNow([...this.listeners.keys()]);
        break;
      case 'serviceCallFailure':
        this.settle(message.callId)?.reject(new Error(codec.text(message.message)));
        break;
      case 'status':
        this.events.status?.(Number(message.level) || 0, codec.text(message.message));
        break;
    }
  }

  private binary(frame: ArrayBuffer): void {
    const message = codec.parseBinary(frame);
    if (message === undefined) return;
    const content = this.json(message.payload);
    if (message.op === 'response') this.settle(message.id)?.resolve(content);
    else if (content !== undefined) this.subscriptions.get(message.id)?.(content);
  }

  private json(payload: Uint8Array): unknown {
    try {
      return JSON.parse(this.decoder.decode(payload)) as unknown;
    } catch {
      return undefined;
    }
  }

  private subscribeNow(topics: string[]): void {
    if (!this.ready) return;
    const wanted: { id: number; channelId: number; interval_ms?: number }[] = [];
    for (const topic of topics) {
      const channelId = this.channels.get(topic);
      const each = this.listeners.get(topic);
      if (channelId === undefined || each === undefined || this.subscribed.has(topic)) continue;
      const id = this.nextSubscription++;
      this.subscriptions.set(id, each.listener);
      this.subscribed.set(topic, id);
      wanted.push(each.interval_ms > 0 ? { id, channelId, interval_ms: each.interval_ms } : { id, channelId });
    }
    if (wanted.length > 0) this.connection.send(JSON.stringify({ op: 'subscribe', subscriptions: wanted }));
  }

  private settle(id: unknown): Call | undefined {
    const call = this.calls.get(id as number);
    this.calls.delete(id as number);
    return call;
  }

  private forget(): void {
    this.isReady = false;
    this.channels.clear();
    this.services.clear();
    this.subscriptions.clear();
    this.subscribed.clear();
    const calls = [...this.calls.values()];
    this.calls.clear();
    for (const call of calls) call.reject(new Error('connection lost'));
  }
}
