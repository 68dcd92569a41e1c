// The connection to the daemon: its messages, the requests of this page, and STOP.
import { Client, type ServerInfo } from '../foxglove/client.ts';
import { openSocket, type Socket } from '../foxglove/connection.ts';
import { StopSender } from '../foxglove/stop_sender.ts';
import { Consent } from '../state/consent.ts';
import { LinkPace } from '../state/link_pace.ts';
import { asksForMotion, type Estimate, type Slip, type State, type Topic } from '../state/messages.ts';
import { past, type Call } from '../state/service.ts';
import { Store } from '../state/store.ts';

const kTopics: Topic[] = ['/state', '/course', '/path_history', '/event', '/parameter', '/recording', '/camera/image'];
/** Not on a link that has once been too slow for the poses. */
const kLarge: Topic = '/camera/image';
/** Channels that say the same again and again: how often this page takes them in motion, and at rest. */
const kMoving_ms = { '/estimate': 40, '/slip': 100, '/link': 500 } as const;
const kResting_ms = { '/estimate': 200, '/slip': 400, '/link': 1000 } as const;
/** Channels for details, which nobody receives who does not look at them. */
const kDetails: Topic[] = ['/sample', '/command', '/loop', '/client'];
/** What the diagrams show of the time before this page was opened. */
const kPast_s = 60;
/** With `/state.watch` the daemon stops a robot that no page in sight has watched for 2 s. */
const kWatch_ms = 500;

interface Listener {
  /** The connection ended. */
  lost(): void;
  /** The daemon complains about something that this page has sent. */
  complaint(text: string): void;
  message(topic: string, message: unknown): void;
}

export class Daemon {
  /** The newest of its messages, whatever the page shows. */
  readonly live = new Store();
  readonly pace = new LinkPace();
  readonly call: Call = (service, request) => this.client.call(service, request);
  readonly consent = new Consent(this.call);
  readonly stop: StopSender;
  metadata: ServerInfo['metadata'] = {};
  private readonly client: Client;
  private retryAt_ms = 0;
  private watching = false;
  private hasPast = false;

  constructor(private readonly listener: Listener) {
    const connect = (): Socket => openSocket(`${location.origin}/`);
    this.client = new Client(connect, {
      serverInfo: (info) => {
        this.metadata = info.metadata;
      },
      ready: () => {
        this.stop.ready();
      },
      closed: (retry_ms) => {
        this.retryAt_ms = performance.now() + retry_ms;
        this.stop.button.disconnected();
        this.consent.forget('The connection was lost');
        this.pace.forget();
        listener.lost();
      },
      status: (level, message) => {
        if (level > 0) listener.complaint(message);
      },
    });
    this.stop = new StopSender(this.client, connect);
  }

  get connected(): boolean {
    return this.client.ready;
  }

  get retryIn_s(): number {
    return (this.retryAt_ms - performance.now()) / 1000;
  }

  /** Whether the daemon takes more than STOP from here. */
  get mayCommand(): boolean {
    return this.metadata.commands !== 'stop';
  }

  /** The Unix time of t_s = 0. */
  get began_unix_s(): number | undefined {
    return Number(this.metadata.start_unix_ns ?? NaN) / 1e9 || undefined;
  }

  /** Receives from now on. */
  start(): void {
    for (const topic of kTopics) this.client.subscribe(topic, (message) => { this.receive(topic, message); });
    this.subscribe(false);
    setInterval(() => { this.watch(); }, kWatch_ms);
  }

  /** The minute before this page was opened is not known yet, and would take a slow link long. */
  get lacksPast(): boolean {
    return !this.hasPast && this.pace.slow;
  }

  loadPast(): void {
    this.hasPast = true;
    Promise.all([past('/estimate', kPast_s), past('/slip', kPast_s)]).then(
      ([estimates, slips]) => { this.live.before(estimates as Estimate[], slips as Slip[]); },
      () => undefined,
    );
  }

  pressStop(): void {
    this.consent.forget('STOP was pressed');
    this.stop.press(performance.now());
  }

  setParameter(name: string, value: number | boolean | string): void {
    this.client.setParameter(name, value);
  }

  /** Receives those channels of details that are wanted, and no others. */
  demand(wanted: (topic: string) => boolean): void {
    for (const topic of kDetails) {
      if (wanted(topic)) this.client.subscribe(topic, (message) => { this.receive(topic, message); });
      else this.client.unsubscribe(topic);
    }
    if (!this.hasPast && this.pace.fast) this.loadPast();
    if (this.pace.slow) this.client.unsubscribe(kLarge);
  }

  private subscribe(moving: boolean): void {
    const intervals = moving ? kMoving_ms : kResting_ms;
    this.pace.expect(intervals['/estimate']);
    for (const topic of ['/estimate', '/slip', '/link'] as const)
      this.client.subscribe(topic, (message) => { this.receive(topic, message); }, intervals[topic]);
  }

  private receive(topic: Topic, message: unknown): void {
    this.live.receive(topic, message as never);
    if (topic === '/state') {
      this.stop.button.received((message as State).stop);
      this.consent.received(message as State);
      this.subscribe(asksForMotion((message as State).run));
    } else if (topic === '/estimate') {
      this.pace.received((message as Estimate).t_s, performance.now());
    }
    // Only the path driven before is needed; from here on the page records its own.
    if (topic === '/path_history') this.client.unsubscribe(topic);
    this.listener.message(topic, message);
  }

  private watch(): void {
    // One call at a time: those that a slow connection keeps would tell later that somebody watched.
    if (this.watching || this.live.get('/state')?.watch !== true || document.visibilityState !== 'visible') return;
    this.watching = true;
    this.call('watch', {}).catch(() => undefined).finally(() => { this.watching = false; });
  }
}
