"""For scripts that start the engine's project: files and settings."""
import json
import os
import subprocess
import sys
import tomllib

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
PROGRAMS = os.path.realpath(os.environ.get("TP100_BIN", ROOT + "/build/dev/bin"))
PATIENCE_S = 60.0  # longest start of a program
POINTS = 2000      # at most, of a course's path


def fail(text):
    print(f"{os.path.basename(sys.argv[0])}: {text}", file=sys.stderr)
    sys.exit(2)


def path_of(name, folder):
    return name if name.endswith(".toml") else f"{ROOT}/config/{folder}/{name}.toml"


def bundled(name, folder):
    """The TOML file of this name in config/FOLDER, or the file itself."""
    path = path_of(name, folder)
    try:
        with open(path, "rb") as file:
            return tomllib.load(file)
    except (OSError, tomllib.TOMLDecodeError) as error:
        fail(f"{path}: {error}; give a file or a name in config/{folder}")


def drawn(name, programs=PROGRAMS):
    """The course of this name in config/courses, or that file, as tp100d describes it on the channel /course
    (daemon/messages/CHANNELS.md), but its path as [x, y] without its segments; and its nominal "duration_s"."""
    if not os.path.exists(programs + "/tp100d"):
        fail("tp100d is not built; run scripts/build dev tp100d")
    path = path_of(name, "courses")
    done = subprocess.run([programs + "/tp100d", "check", "--json", path], capture_output=True, text=True)
    if done.returncode:
        fail(f"{done.stderr.strip()}; give a file or a name in config/courses")
    answer = json.loads(done.stdout)
    course = answer["course"] | {"duration_s": answer.get("duration_s", 0.0)}
    points = [[round(point["x_m"], 4), round(point["y_m"], 4)] for point in course["path"]]
    del course["segments"]
    return course | {"path": points[:-1:len(points) // POINTS + 1] + points[-1:]}


def engine_environment(variable, settings):
    """The environment with the settings of the engine's project; the engine does not support the locale C."""
    return os.environ | {variable: json.dumps(settings), "LANG": "en_US.UTF-8", "LC_ALL": "en_US.UTF-8"}
