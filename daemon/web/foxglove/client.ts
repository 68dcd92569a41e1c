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
  private readonly listeners = new Map<string, Listener>();
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

  /** Messages of `topic` from now on, across reconnections. One listener per topic. */
  subscribe(topic: string, listener: Listener): void {
    this.listeners.set(topic, listener);
    this.subscribeNow([topic]);
  }

  unsubscribe(topic: string): void {
    this.listeners.delete(topic);
    const id = this.subscribed.get(topic);
    if (id === undefined) return;
    this.subscribed.delete(topic);
    this.subscriptions.delete(id);
    this.connection.send(codec.unsubscribe([id]));
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
    this.connection.send(codec.setParameter(name, value));
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
    switch (message?.op) {
      case 'serverInfo':
        this.events.serverInfo({ sessionId: message.sessionId, metadata: message.metadata });
        break;
      case 'advertise':
        for (const { id, topic } of message.channels) this.channels.set(topic, id);
        if (this.isReady) this.subscribeNow([...this.listeners.keys()]);
        break;
      case 'advertiseServices':
        for (const { id, name } of message.services) this.services.set(name, id);
        if (this.isReady) break;
        this.isReady = true;
        this.events.ready();
        this.subscribeNow([...this.listeners.keys()]);
        break;
      case 'serviceCallFailure':
        this.settle(message.callId)?.reject(new Error(message.message));
        break;
      case 'status':
        this.events.status?.(message.level, message.message);
        break;
      case undefined:
        break;
    }
  }

  private binary(frame: ArrayBuffer): void {
    const message = codec.parseBinary(frame);
    if (message?.op === 'message') {
      const listener = this.subscriptions.get(message.subscriptionId);
      if (listener === undefined) return;
      const content = this.json(message.payload);
      if (content !== undefined) listener(content);
    } else if (message?.op === 'serviceResponse') {
      this.settle(message.callId)?.resolve(this.json(message.payload));
    }
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
    const wanted: { id: number; channelId: number }[] = [];
    for (const topic of topics) {
      const channelId = this.channels.get(topic);
      const listener = this.listeners.get(topic);
      if (channelId === undefined || listener === undefined || this.subscribed.has(topic)) continue;
      const id = this.nextSubscription++;
      this.subscriptions.set(id, listener);
      this.subscribed.set(topic, id);
      wanted.push({ id, channelId });
    }
    if (wanted.length > 0) this.connection.send(codec.subscribe(wanted));
  }

  private settle(id: number): Call | undefined {
    const call = this.calls.get(id);
    this.calls.delete(id);
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
