"""One row of the lockstep table from the JSON lines of `tp100-sim course --json` on standard input."""
import json
import statistics
import sys

runs = [json.loads(line) for line in sys.stdin]
speed = sorted(run["realtime_factor"] for run in runs)
step = statistics.median(run["loop"]["mean_step_us"] for run in runs)
print("  {:7s} {:12s} {:12s} {:8.1f} {:8.1f} {:8.1f} {:14.2f}".format(
    runs[0]["board"], runs[0]["course"], runs[0]["robot"], speed[0], statistics.median(speed), speed[-1], step))
