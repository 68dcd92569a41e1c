// Work that is due when the browser draws.

export interface Task {
  /** At most once in this time; 0: at every frame. */
  period_ms: number;
  run(now_ms: number): void;
}

/** Runs the tasks from the next frame on, in this order, for as long as the page lives. */
export function everyFrame(tasks: readonly Task[]): void {
  const due_ms = tasks.map(() => 0);
  const frame = (now_ms: number): void => {
    tasks.forEach((task, i) => {
      if (now_ms < (due_ms[i] ?? 0)) return;
      due_ms[i] = now_ms + task.period_ms;
      task.run(now_ms);
    });
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}
