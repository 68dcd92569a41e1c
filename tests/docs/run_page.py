#!/usr/bin/env python3
"""run_page.py PAGE BUILD: follows the instructions of a page literally: writes its files, runs its commands.

```sh blocks are run one after the other by one bash in a folder that looks like the project's, with BUILD as
build/dev; a block whose first line has a file's name after the language is written to that file. Any command that
fails fails the page. A word after ```sh marks the block:

    instead   stands in for what a test does not have: an emulated robot on $port, another port number
    enter     Enter is pressed twice a second
    start     each run is started as the daemon requests: by Enter, or by the word go and Enter
    others    the block is not run; the word is the reason: long, by-hand, fresh, install, ...

Blocks in other languages are not touched.
"""
import os
import re
import shlex
import subprocess
import sys
import tempfile
import textwrap

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BLOCK = re.compile(r"^( *)```(\w+)(?: (\S+))?\n(.*?)^\1```$", re.M | re.S)


def blocks(path):
    """Language, word and text of each block of a page."""
    with open(path, encoding="utf-8") as file:
        return [(language, word, textwrap.dedent(body)) for _, language, word, body in BLOCK.findall(file.read())]


# Forwards the output of a block and types the input that it requests.
STARTER = """start_runs() {
  while IFS= read -r line; do
    printf '%s\\n' "$line" >&2
    case $line in
      *"type go"*"press Enter to start"*) echo go start > .keys ;;
      *"press Enter to start"*) echo > .keys ;;
    esac
  done
}
mkfifo .keys"""


def script_of(page):
    lines = ["set -euo pipefail", STARTER]
    for language, word, body in page:
        if language == "sh" and word in ("", "instead", "enter", "start"):
            source = {"enter": " < <(while sleep 0.5; do echo; done)",
                      "start": " <> .keys 2> >(start_runs)"}.get(word, "")
            lines.append("{ set -x\n" + body + "{ set +x; } 2>/dev/null\n}" + source)
        elif language != "sh" and word:
            lines.append(f"printf %s {shlex.quote(body)} > {shlex.quote(word)}")
    return "\n".join(lines)


def main():
    page, build = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    script = script_of(blocks(page))
    if "set -x" not in script:
        sys.exit(f"{page}: has no commands")
    with tempfile.TemporaryDirectory(prefix="tp100-docs-") as folder:
        for name in os.listdir(ROOT):
            if name not in ("build", ".git"):
                os.symlink(os.path.join(ROOT, name), os.path.join(folder, name))
        os.mkdir(os.path.join(folder, "build"))
        os.symlink(build, os.path.join(folder, "build", "dev"))
        # Black boxes of failed runs are written here, too.
        here = dict(os.environ, XDG_STATE_HOME=os.path.join(folder, "state"))
        shell = subprocess.Popen(["bash", "-c", script], cwd=folder, env=here, stdin=subprocess.DEVNULL,
                                 start_new_session=True)
        # Ends the page's programs at the end of the pipe, which comes when this program ends for any reason.
        keeper = subprocess.Popen(["sh", "-c", 'read -r _; kill -s TERM -- "-$1" 2> /dev/null', "keeper", str(shell.pid)],
                                  stdin=subprocess.PIPE, start_new_session=True)
        status = shell.wait()
        keeper.communicate()
    if status:
        sys.exit(f"{page}: the last command above ended with status {status}")


if __name__ == "__main__":
    main()
