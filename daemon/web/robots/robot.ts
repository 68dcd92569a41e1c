// The robots of the page, each with the connection to its daemon, its last messages and STOP; and which are shown.
import { Client, type ServerInfo } from '../foxglove/client.ts';
import { openSocket, type Socket } from '../foxglove/connection.ts';
import { StopSender } from '../foxglove/stop_sender.ts';
import type { Course, Link, State } from '../state/messages.ts';
import { kStaleState_ms } from '../state/store.ts';

/** An entry of GET /api/robots. */
export interface Listed {
  url: string;
  /** The daemon's sessionId; not known for robots that the configuration names. */
  session?: string;
  /** True: this daemon serves this page. */
  own?: boolean;
}

export type Contact =
  /** Nothing was received yet. */
  | 'connecting'
  | 'answers'
  | 'no_answer'
  /** Another daemon answers at the address. */
  | 'other';

/** After this time without an answer the page reports that there is none, although the browser still tries. */
const kPatience_ms = 2000;
const kLink_ms = 1000;

export class Robot {
  readonly stop: StopSender;
  state: State | undefined;
  link: Link | undefined;
  course: Course | undefined;
  /** Its name as displayed; empty until its daemon has answered. */
  name = '';
  private readonly client: Client;
  private readonly began_ms: number;
  private received_ms: number | undefined;
  private connected = false;
  private other = false;

  constructor(
    readonly listed: Listed,
    private readonly now: () => number = () => performance.now(),
    make: () => Socket = () => openSocket(listed.url),
  ) {
    this.began_ms = now();
    const same = ({ sessionId }: ServerInfo): boolean => listed.session === undefined || listed.session === sessionId;
    this.client = new Client(make, {
      serverInfo: (info) => {
        this.other = !same(info);
        if (!this.other) this.name = info.metadata.name ?? '';
      },
      ready: () => {
        // Another daemon may answer, for instance if a tunnel now leads to another machine.
        this.connected = !this.other;
        if (this.connected) this.stop.ready();
      },
      closed: () => {
        this.connected = false;
        this.received_ms = undefined;
        this.stop.button.disconnected();
      },
    }, now);
    const client = this.client;
    const mine = (): boolean => this.connected;
    this.stop = new StopSender({
      get ready() { return mine() && client.ready; },
      call: (name) => client.call(name),
      retryNow: () => { client.retryNow(); },
    }, make, same);
    client.subscribe('/state', (message) => {
      if (!this.connected) return;
      this.state = message as State;
      this.received_ms = now();
      this.stop.button.received(this.state.stop);
    });
    client.subscribe('/link', (message) => {
      if (this.connected) this.link = message as Link;
    }, kLink_ms);
    client.subscribe('/course', (message) => {
      if (this.connected) this.course = message as Course;
    });
  }

  get contact(): Contact {
    if (this.other) return 'other';
    const now_ms = this.now();
    if (this.received_ms !== undefined) return now_ms - this.received_ms > kStaleState_ms ? 'no_answer' : 'answers';
    return this.state === undefined && now_ms - this.began_ms < kPatience_ms ? 'connecting' : 'no_answer';
  }

  end(): void {
    this.client.end();
    this.stop.end();
  }
}

/** A daemon that ended stays on the page for this long, so that its card does not vanish at once. */
export const kEnded_ms = 60_000;

/** The part of a robot that the list uses. */
interface Member {
  readonly listed: Listed;
  readonly contact: Contact;
  end(): void;
}

export class RobotList<T extends Member> {
  /** In the order of the list; those that are no longer listed keep their place. */
  readonly robots: T[] = [];
  private readonly unlisted_ms = new Map<T, number>();

  constructor(private readonly make: (listed: Listed) => T) {}

  /** True if the robot is no longer listed and does not answer. */
  ended(robot: T): boolean {
    return this.unlisted_ms.has(robot) && robot.contact !== 'answers';
  }

  take(listed: readonly Listed[], now_ms: number): void {
    const key = ({ url, session }: Listed): string => `${url} ${session ?? ''}`;
    const keys = new Set(listed.map(key));
    const known = new Set(this.robots.map((robot) => key(robot.listed)));
    for (const each of listed) {
      if (known.has(key(each))) continue;
      known.add(key(each));
      this.robots.push(this.make(each));
    }
    for (const robot of this.robots) {
      if (keys.has(key(robot.listed)) || robot.contact === 'answers') this.unlisted_ms.delete(robot);
      else if (!this.unlisted_ms.has(robot)) this.unlisted_ms.set(robot, now_ms);
    }
    for (const [robot, since_ms] of this.unlisted_ms) {
      if (robot.contact !== 'other' && now_ms - since_ms < kEnded_ms) continue;
      robot.end();
      this.unlisted_ms.delete(robot);
      this.robots.splice(this.robots.indexOf(robot), 1);
    }
  }
}
