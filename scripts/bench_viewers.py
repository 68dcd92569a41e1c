"""scripts/bench viewers: lateness of the loop without viewers and with 50, three of them hostile.

Usage: bench_viewers.py FOLDER_OF_PROGRAMS [SECONDS [REPEATS]]
"""
import json
import os
import re
import signal
import statistics
import subprocess
import sys
import tempfile


def memory_kib(pid, key):
    with open(f"/proc/{pid}/status") as status:
        return int(re.search(key + r":\s+(\d+)", status.read()).group(1))


def measure(programs, viewers, seconds):
    """One run of both programs; figures of the daemon."""
    with tempfile.TemporaryDirectory(prefix="tp100-bench-") as folder:
        link, stats = os.path.join(folder, "robot"), os.path.join(folder, "stats.json")
        robot = subprocess.Popen([os.path.join(programs, "tp100-sim"), "robot", "--link", link],
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        daemon = subprocess.Popen([os.path.join(programs, "tp100d"), "run", "--port", link, "--wait",
                                   "--listen", "127.0.0.1:0", "--stats", stats],
                                  stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        try:
            for line in daemon.stderr:
                page = re.search(r"page: http://127.0.0.1:(\d+)/", line)
                if page:
                    break
            load = {}
            command = ["sleep", str(seconds)]
            if viewers:
                command = [os.path.join(programs, "viewer_load"), page.group(1), str(seconds)]
            out = subprocess.run(command, capture_output=True, text=True, check=True).stdout
            if viewers:
                load = json.loads(out)
            peak = memory_kib(daemon.pid, "VmHWM")
            with open(f"/proc/{daemon.pid}/stat") as stat:
                fields = stat.read().rsplit(") ", 1)[1].split()
            cpu_s = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
        finally:
            daemon.send_signal(signal.SIGTERM)
            daemon.stderr.read()
            daemon.wait()
            robot.send_signal(signal.SIGTERM)
            robot.wait()
        with open(stats) as file:
            loop = json.load(file)["loop"]
    return {**loop["lateness_us"], "overruns": loop["overruns"], "turns": loop["turns"],
            "peak_mib": peak / 1024, "cpu": cpu_s / seconds, **load}


def main():
    programs = sys.argv[1]
    seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 20.0
    repeats = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    runs = {0: [], 50: []}
    for _ in range(repeats):
        for viewers, list_of in runs.items():
            list_of.append(measure(programs, viewers, seconds))
    print(f"viewers: lateness of the loop [us], {repeats} runs of {seconds:.0f} s each, medians")
    print(f"  {'':10} {'none':>10} {'50':>10} {'ratio':>8}")
    for key in ("p50", "p99", "p999", "max"):
        none, many = (statistics.median(run[key] for run in runs[n]) for n in (0, 50))
        print(f"  {key:10} {none:10.1f} {many:10.1f} {many / none if none else float('nan'):8.2f}")
    for key, text in (("overruns", "overruns"), ("peak_mib", "peak MiB"), ("cpu", "cores")):
        none, many = (statistics.median(run[key] for run in runs[n]) for n in (0, 50))
        print(f"  {text:10} {none:10.2f} {many:10.2f}")
    dropped = [run["dropped"] for run in runs[50]]
    received = [run["received"] / seconds / 47 for run in runs[50]]
    print(f"  messages dropped for the viewer that never reads: {dropped}")
    print(f"  messages a second that each of the 47 others got: {[round(r) for r in received]}")


if __name__ == "__main__":
    main()
