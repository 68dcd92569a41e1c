// One WebSocket that reconnects by itself: opens, detects silence, closes, waits, opens again.
import { kSubprotocols } from './codec.ts';

/** The part of a WebSocket that Connection uses; a test passes its own. */
export type Socket = Pick<WebSocket, 'send' | 'close' | 'onopen' | 'onclose' | 'onmessage'>;

/** A new connection to the daemon whose page has this address. */
export function openSocket(url: string): Socket {
  const socket = new WebSocket(url.replace(/^http/, 'ws'), kSubprotocols);
  socket.binaryType = 'arraybuffer';
  return socket;
}

export interface ConnectionEvents {
  /** The connection ended; it is retried in `retry_ms`. */
  closed(retry_ms: number): void;
  text(frame: string): void;
  binary(frame: ArrayBuffer): void;
}

export const kFirstRetry_ms = 200;
export const kLongestRetry_ms = 2000;
/** A daemon sends at least five times a second; a silent socket is dead. */
export const kSilence_ms = 3000;
/** A hung daemon may recover; until then presses are queued. */
export const kOpening_ms = 10_000;
const kWatch_ms = 500;

export class Connection {
  private socket: Socket | undefined;
  private isOpen = false;
  /** Time without a message while this page was awake. */
  private silent_ms = 0;
  private watched_ms = 0;
  private retry_ms = kFirstRetry_ms;
  private retryTimer: ReturnType<typeof setTimeout> | undefined;
  private readonly watchTimer: ReturnType<typeof setInterval>;

  constructor(
    private readonly make: () => Socket,
    private readonly events: ConnectionEvents,
    private readonly now: () => number = () => performance.now(),
  ) {
    this.watched_ms = this.now();
    this.watchTimer = setInterval(() => {
      this.watch();
    }, kWatch_ms);
    this.open();
  }

  get connected(): boolean {
    return this.isOpen;
  }

  /** Does nothing without a connection. */
  send(data: string | ArrayBuffer): void {
    if (this.isOpen) this.socket?.send(data);
  }

  /** Retries at once instead of waiting. */
  retryNow(): void {
    if (this.retryTimer === undefined) return;
    clearTimeout(this.retryTimer);
    this.open();
  }

  /** Closes it for good. */
  end(): void {
    clearInterval(this.watchTimer);
    this.drop();
    clearTimeout(this.retryTimer);
    this.retryTimer = undefined;
  }

  private open(): void {
    this.retryTimer = undefined;
    const socket = this.make();
    this.socket = socket;
    this.silent_ms = 0;
    socket.onopen = () => {
      this.isOpen = true;
      this.silent_ms = 0;
      this.retry_ms = kFirstRetry_ms;
    };
    socket.onmessage = (event) => {
      const data: unknown = event.data;
      this.silent_ms = 0;
      if (typeof data === 'string') this.events.text(data);
      else if (data instanceof ArrayBuffer) this.events.binary(data);
    };
    socket.onclose = () => {
      this.drop();
    };
  }

  private watch(): void {
    // At most one watch period: a page that was suspended or got no processor time was not listening.
    const now_ms = this.now();
    this.silent_ms += Math.min(now_ms - this.watched_ms, kWatch_ms);
    this.watched_ms = now_ms;
    if (this.socket !== undefined && this.silent_ms > (this.isOpen ? kSilence_ms : kOpening_ms)) this.drop();
  }

  private drop(): void {
    const socket = this.socket;
    if (socket === undefined) return;
    socket.onopen = socket.onclose = socket.onmessage = null;
    socket.close();
    this.socket = undefined;
    this.isOpen = false;
    const wait_ms = this.retry_ms;
    this.retry_ms = Math.min(2 * wait_ms, kLongestRetry_ms);
    this.retryTimer = setTimeout(() => {
      this.open();
    }, wait_ms);
    this.events.closed(wait_ms);
  }
}
