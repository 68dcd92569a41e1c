// Periodic work, done when the browser draws a frame.

export interface Task {
  /** Least time between two runs; 0: at every frame. */
  period_ms: number;
  run(now_ms: number): void;
}

/** Runs the tasks from the next frame on, in this order, as long as the page exists. */
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
