"""The page of scripts/experiment: what holds, the tables beside the paper's figures, paths, and every run."""
import html
import os
import re
import statistics

OLDEST_ANSWER_MS = 20.0  # limit: 99 % of a run's steps know an answer of the world that is younger
# The paper's largest position errors; of course 2 it prints none. Of course 3: the largest deviation.
PAPER_CM = {"1-straight": "1.56", "1-curve": "1.20", "1-sharp": "8.58", "3": "34.1"}
# As in the reports of runs, whose style adapts them to light and dark.
PATH, FLOOR, ENGINE = "#5b6672", "#806200", "#c42b24"


def number(value, digits=1):
    return "-" if value is None else f"{value:.{digits}f}"


def age_p99_ms(run):
    return run.get("answer_age_ms", {}).get("p99")


def median_and_worst(runs, key, digits=1):
    values = [run[key] for run in runs if run.get(key) is not None]
    return f"{statistics.median(values):.{digits}f} / {max(values):.{digits}f}" if values else "-"


def summary(run):
    """One line about a run."""
    text = f"{run['course']}, {run['setup']}, {run['board']}, seed {run['seed']}: "
    text += f"completed in {run['duration_s']:.1f} s" if run["completed"] else "not completed: " + run["cause"]
    if run.get("end_cm") is not None:
        text += f", off by {run['end_cm']:.1f} cm at the end, {run['largest_cm']:.1f} cm at most"
    if age_p99_ms(run) is not None:
        text += f", answers {age_p99_ms(run):.1f} ms old, {run['missed']} of {run['cycles']} cycles missed"
    return text


def holds(data):
    """Whether all runs hold the limits, and a sentence about it."""
    runs = data["runs"]
    completed = sum(run["completed"] for run in runs)
    ages = [age_p99_ms(run) for run in runs if age_p99_ms(run) is not None]
    worst_ms = round(max(ages, default=float("inf")), 1)
    text = f"{completed} of {len(runs)} runs were completed"
    if ages:
        text += (f"; in 99 % of a run's steps the world's newest answer was at most {worst_ms:.1f} ms old "
                 f"(worst run; limit {OLDEST_ANSWER_MS:g} ms)")
    return bool(runs) and completed == len(runs) and worst_ms <= OLDEST_ANSWER_MS, text


def table(rows, caption):
    """The first row is the head; a cell that begins with < is HTML."""
    def cell(tag, text):
        return f"<{tag}>{text if text.startswith('<') else html.escape(text)}</{tag}>"
    caption = html.escape(caption)
    head, *body = ["".join(cell("td" if i else "th scope='col'", text) for text in row) for i, row in enumerate(rows)]
    head = re.sub(r"</th scope='col'>", "</th>", head)
    return (f"<div class='scroll' tabindex='0' role='group' aria-label='{caption}'><table><caption>{caption}</caption>"
            f"<thead><tr>{head}</tr></thead>" + "".join(f"<tr>{row}</tr>" for row in body) + "</table></div>\n")


def drawing(lines):
    """SVG of paths on the floor, x to the right: (colour, dashed, points [m]) each."""
    points = [point for _, _, line in lines for point in line]
    left, right = min(p[0] for p in points) - 0.1, max(p[0] for p in points) + 0.1
    low, high = min(p[1] for p in points) - 0.1, max(p[1] for p in points) + 0.1
    width = 500
    scale = width / (right - left)
    text = f"<svg viewBox='0 0 {width} {(high - low) * scale:.0f}' role='img' aria-label='paths'>"
    for colour, dashed, line in lines:
        places = " ".join(f"{(x - left) * scale:.1f},{(high - y) * scale:.1f}" for x, y in line)
        text += (f"<polyline points='{places}' fill='none' stroke='{colour}' stroke-width='{2 if dashed else 1}'"
                 + (" stroke-dasharray='6 4'" if dashed else "") + "/>")
    return text + "</svg>"


def paths(data, course, setup):
    runs = [run for run in data["runs"] if (run["course"], run["setup"]) == (course, setup) and run.get("engine")]
    if not runs:
        return ""
    lines = [(FLOOR, False, run["floor"]) for run in runs if run.get("floor")]
    lines += [(ENGINE, False, run["engine"]) for run in runs] + [(PATH, True, data["paths"][course])]
    return f"<figure>{drawing(lines)}<figcaption>Course {html.escape(course)}, {setup}</figcaption></figure>\n"


def beside_the_paper(data):
    rows = [["course", "paper, real robot", "emulator alone", "built-in world", "Godot, live, native", "Godot, live, avr"]]

    def pair(of):
        return "-" if of is None else f"{number(of.get('model_largest_cm'))} / {number(of['largest_cm'])}"

    def live(course, board):
        runs = [run for run in data["runs"] if (run["course"], run["setup"], run["board"]) == (course, "flat", board)
                and run.get("largest_cm") is not None]
        if not runs:
            return None
        middle = {"largest_cm": statistics.median(run["largest_cm"] for run in runs)}
        if all(run.get("model_largest_cm") is not None for run in runs):
            middle["model_largest_cm"] = statistics.median(run["model_largest_cm"] for run in runs)
        return middle
    for course, of in data["virtual"].items():
        rows.append([course, PAPER_CM.get(course, "-"), pair(of.get("terrain")), pair(of.get("flat")),
                     pair(live(course, "native")), pair(live(course, "avr"))])
    return table(rows, "Largest position error [cm], model / odometry, against the robot's true place; medians of the runs")


def by_kind(data):
    rows = [["course", "set-up", "board", "completed", "end [cm]", "largest [cm]", "from the path [cm]",
             "answer's age p99 [ms]", "round trip max [ms]", "cycles missed"]]
    kinds = {}
    for run in data["runs"]:
        kinds.setdefault((run["setup"], run["board"], run["course"]), []).append(run)
    for (setup, board, course), runs in sorted(kinds.items()):
        measured = [{"age": age_p99_ms(run), "trip": run["round_trip_ms"]["max"]} for run in runs if "round_trip_ms" in run]
        rows.append([course, setup, board, f"{sum(run['completed'] for run in runs)} of {len(runs)}",
                     median_and_worst(runs, "end_cm"), median_and_worst(runs, "largest_cm"),
                     median_and_worst(runs, "path_cm"), median_and_worst(measured, "age"),
                     median_and_worst(measured, "trip"),
                     f"{sum(run.get('missed', 0) for run in runs)} of {sum(run.get('cycles', 0) for run in runs)}"])
    return table(rows, "Godot, live: median / worst run. End and largest: odometry against the robot's true place on the "
                 "flat floor; a stand has none. From the path: the steering pose in the engine's world")


def every_run(data, folder):
    rows = [["course", "set-up", "board", "seed", "result", "duration [s]", "end [cm]", "largest [cm]", "model [cm]",
             "from the path [cm]", "age p50, p99, max [ms]", "poses answered", "cycles missed", "lateness p99 [us]"]]
    for run in sorted(data["runs"], key=lambda run: (run["setup"], run["board"], run["course"], run["seed"])):
        result = "completed" if run["completed"] else run["cause"]
        report = os.path.join(run["folder"], "report.html")
        shown = html.escape(result)
        if os.path.exists(os.path.join(folder, report)):
            shown = f"<a href='{html.escape(report)}'>{shown}</a>"
        if not run["completed"]:
            shown = f"<span class='missed'>{shown}</span>"
        age = run.get("answer_age_ms", {})
        rows.append([run["course"], run["setup"], run["board"], str(run["seed"]), shown, number(run.get("duration_s")),
                     number(run.get("end_cm")), number(run.get("largest_cm")), number(run.get("model_largest_cm")),
                     number(run.get("path_cm")), ", ".join(number(age.get(key)) for key in ("p50", "p99", "max")),
                     f"{run.get('answered')} of {run.get('poses')}", str(run.get("missed", "-")),
                     number(run.get("lateness_p99_us"), 0)])
    return table(rows, "Every run; its report is behind the result")


def style(data, folder):
    """As the reports of the runs have it."""
    for run in data["runs"]:
        report = os.path.join(folder, run["folder"], "report.html")
        if os.path.exists(report):
            with open(report) as file:
                found = re.search(r"<style>.*?</style>", file.read(), re.S)
            if found:
                return found.group(0)
    return ""


def page(data, folder):
    """One offline page beside the folders of the runs."""
    good, verdict = holds(data)
    settings = data["settings"]
    setups = ("flat", "stand")
    film = ""
    if os.path.exists(os.path.join(folder, "film.mp4")):
        film = ("<h2>In the engine</h2>\n<figure class='wide'><video controls width='100%' poster='film.png' src='film.mp4'>"
                "</video><figcaption>The same course in lockstep, rendered off screen: path blue, robot in the engine red, "
                "real robot on its flat floor yellow</figcaption></figure>\n")
    return (
        "<!doctype html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
        "content='width=device-width,initial-scale=1'><title>The paper's experiment with a game engine as the world</title>"
        f"{style(data, folder)}<style>td,th{{white-space:nowrap}}</style></head><body><main>\n<h1>The paper's experiment with a game engine as the world</h1>\n"
        f"<p class='verdict {'good' if good else 'bad'}'>{html.escape(verdict)}.</p>\n"
        f"<p>Robot {html.escape(settings['robot'])}, emulated in real time and joined to the daemon by a pseudo-terminal; "
        f"Godot without a display answers over UDP; authority {settings['authority']}. Engine and daemon go before other "
        "programs of this machine, where it allows that, as the robot does. On the flat floor the robot really "
        "drives, ramp and step exist only in the engine; on the stand its tracks run free.</p>\n"
        "<h2>Beside the paper</h2>\n" + beside_the_paper(data) +
        "<p>Emulator alone: in virtual time, ramp and step are really there and climbed. Built-in world: in virtual time on "
        "the flat floor. Both on the board native. The model is judged piece by piece between disturbances there; live it is "
        "not judged where there are any. Lengths and radii of the courses are ours, the paper does not print them; its 34.1 "
        "cm is the largest deviation that it prints for course 3.</p>\n"
        "<h2>Live</h2>\n" + by_kind(data) +
        "<h2>Paths</h2>\n<p>Dashed: the course. Red: the robot in the engine. Yellow: the robot on its real floor, all runs "
        "over each other. Where it climbs, it covers less ground than on the floor.</p>\n"
        + "".join(paths(data, course, setup) for setup in setups for course in data["virtual"])
        + film + "<h2>Every run</h2>\n" + every_run(data, folder) + "</main></body></html>\n")
