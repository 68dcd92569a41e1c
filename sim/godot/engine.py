"""For scripts that start the engine's project: files and settings."""
import json
import os
import sys
import tomllib

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
PATIENCE_S = 60.0  # longest start of a program


def fail(text):
    print(f"{os.path.basename(sys.argv[0])}: {text}", file=sys.stderr)
    sys.exit(2)


def bundled(name, folder):
    """The TOML file of this name in config/FOLDER, or the file itself."""
    path = name if name.endswith(".toml") else f"{ROOT}/config/{folder}/{name}.toml"
    try:
        with open(path, "rb") as file:
            return tomllib.load(file)
    except (OSError, tomllib.TOMLDecodeError) as error:
        fail(f"{path}: {error}; give a file or a name in config/{folder}")


def engine_environment(variable, settings):
    """The environment with the settings of the engine's project; the engine does not support the locale C."""
    return os.environ | {variable: json.dumps(settings), "LANG": "en_US.UTF-8", "LC_ALL": "en_US.UTF-8"}
