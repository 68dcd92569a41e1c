// The robots that the page shows: those listed, and for a while those that are no longer listed.
import type { Contact, Listed } from './robot.ts';

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
