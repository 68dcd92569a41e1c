"""What the --help of a program says, for scripts/manual.py."""
import os
import re
import subprocess


class Command:
    """A program or one of its subcommands, as its --help describes it."""

    def __init__(self, program, name=None):
        call = [program, name, "--help"] if name else [program, "--help"]
        text = subprocess.run(call, check=True, capture_output=True, text=True).stdout
        lines = text.splitlines()
        self.name = name or os.path.basename(program)
        self.about = lines[0]
        self.usage = next(line for line in lines if line.startswith("Usage: ")).removeprefix("Usage: ")
        self.positionals, self.options, self.subcommands = [], [], []
        self._read(lines[lines.index("Usage: " + self.usage) + 1:])

    def _read(self, lines):
        parts = {"Positionals:": self.positionals, "Options:": self.options, "Subcommands:": self.subcommands}
        part = None
        for line in lines:
            if line in parts:
                part = parts[line]
            elif not line or part is None:
                part = None
            elif row := re.fullmatch(r"  (\S.*?)(?:  +(\S.*))?", line):
                part.append([row[1], row[2] or ""])
            else:
                part[-1][1] = (part[-1][1] + " " + line.strip()).strip()

    def arguments(self):
        """(names, value, explanation) of each option; the value is empty for a flag."""
        for left, text in self.options:
            names, _, value = left.partition(" ")
            names = re.sub(r"{.*?}", "", names).split(",")
            takes = "{" not in left.partition(" ")[0] and value != "REQUIRED"
            yield names, re.split(r"[ :=]", value)[0] if takes else "", text

    def follows(self):
        """What the first positional argument is called; empty: there is none."""
        if not self.positionals:
            return ""
        name, kind = (self.positionals[0][0].split() + [""])[:2]
        return name if kind == "TEXT" else kind


def commands_of(program):
    top = Command(program)
    return top, [Command(program, name) for name, _ in top.subcommands]
