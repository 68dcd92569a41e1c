"""Tables, percentiles and the results file that the parts of scripts/bench share."""
import json
import os
import platform
import subprocess
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RESULTS = os.environ.get("TP100_BENCH_JSON", os.path.join(ROOT, "build", "bench", "results.json"))


def seconds(usual):
    """Duration of one measurement [s]: TP100_BENCH_SECONDS, by default `usual`."""
    return float(os.environ.get("TP100_BENCH_SECONDS", usual))


def rounds(usual):
    """Number of measurements of each candidate: TP100_BENCH_ROUNDS, by default `usual`."""
    return int(os.environ.get("TP100_BENCH_ROUNDS", usual))


def percentile(values, fraction):
    """The one of unsorted values below which `fraction` (0..1) of them lie."""
    ordered = sorted(values)
    return ordered[min(int(fraction * len(ordered)), len(ordered) - 1)]


def ratio(ours, theirs):
    """The ratio, or None if there is nothing to compare with."""
    return ours / theirs if theirs else None


class Busy:
    """Keeps every processor busy with a process of its own, as a context; `busy` False starts none."""

    def __init__(self, busy=True):
        self.count = os.cpu_count() if busy else 0

    def __enter__(self):
        self.processes = [subprocess.Popen(["sh", "-c", "while :; do :; done"]) for _ in range(self.count)]

    def __exit__(self, *_):
        for process in self.processes:
            process.kill()
            process.wait()


class Table:
    """Prints each row as it is added; save() writes all of them to the results file.

    A column is (key, heading, format); the format is that of str.format for one value, e.g. "8.1f". A missing value or
    None is printed as "-".
    """

    def __init__(self, part, title, columns):
        self.part, self.title, self.columns, self.rows = part, title, columns, []
        print(f"{part}: {title}")
        self._print([heading for _, heading, _ in columns])

    def row(self, **values):
        self.rows.append(values)
        self._print([format(values[key], kind) if values.get(key) is not None else "-"
                     for key, _, kind in self.columns])

    def _print(self, cells):
        texts = []
        for (_, heading, kind), cell in zip(self.columns, cells):
            left = kind.startswith("<")
            width = max(len(heading), int("".join(c for c in kind.lstrip("<").split(".")[0] if c.isdigit()) or 0))
            texts.append(cell.ljust(width) if left else cell.rjust(width))
        print("  " + "  ".join(texts).rstrip(), flush=True)

    def note(self, text):
        print(f"  {text}", flush=True)

    def save(self):
        """Replaces this part in the results file and keeps the others."""
        os.makedirs(os.path.dirname(os.path.abspath(RESULTS)), exist_ok=True)
        results = {"parts": {}}
        if os.path.exists(RESULTS):
            with open(RESULTS) as file:
                results = json.load(file)
        results["machine"] = {"kernel": platform.release(), "processors": os.cpu_count()}
        results["parts"][self.part] = {
            "title": self.title, "at": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime()),
            "load_average": os.getloadavg()[0], "rows": self.rows}
        with open(RESULTS + ".new", "w") as file:
            json.dump(results, file, indent=1)
            file.write("\n")
        os.replace(RESULTS + ".new", RESULTS)
