#!/usr/bin/env python3
"""scripts/manual.py PROGRAM VERSION FOLDER: writes the man page NAME.1.gz of PROGRAM, from its --help, to FOLDER."""
import gzip
import os
import re
import subprocess
import sys

EXIT_STATUS = (("0", "done, and within limits"), ("1", "the run failed or broke a limit"),
               ("2", "bad usage, a bad file, or a port that is missing or busy"),
               ("3", "stopped by want of memory or a defect; report it if it comes back"))
FILES = (("/etc/tp100/NAME.toml", "configuration of the service tp100d@NAME"),
         ("/usr/share/tp100", "courses, robots and cameras by name, every key of the configuration, and the firmware"),
         ("/var/lib/tp100/NAME", "what the service writes: the seconds around a fault"))
SEE_ALSO = ("tp100d", "tp100-camera", "tp100-campaign", "tp100-flash", "tp100-sim")


class Command:
    """A program or one of its subcommands, as its --help describes it."""

    def __init__(self, *call):
        text = subprocess.run([*call, "--help"], check=True, capture_output=True, text=True).stdout
        lines = text.splitlines()
        self.about = lines[0]
        self.usage = next(line for line in lines if line.startswith("Usage: ")).removeprefix("Usage: ")
        self.examples = [line.removeprefix("Example: ") for line in lines if line.startswith("Example: ")]
        # Of each part the rows, as [left, explanation].
        self.parts = {"Positionals:": [], "Options:": [], "Subcommands:": []}
        part = None
        for line in lines[lines.index("Usage: " + self.usage) + 1:]:
            if line in self.parts:
                part = self.parts[line]
            elif not line or part is None:
                part = None
            elif row := re.fullmatch(r"  (\S.*?)(?:  +(\S.*))?", line):
                part.append([row[1], row[2] or ""])
            else:
                part[-1][1] = (part[-1][1] + " " + line.strip()).strip()

    def arguments(self):
        return self.parts["Positionals:"] + self.parts["Options:"]


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text[:1] in (".", "'") else text


def table(title, rows):
    out = [f".SH {title}"] if title else []
    for left, text in rows:
        out += [".TP", f".B {roff(left)}", roff(text)]
    return out


def manual(name, top, subcommands, version):
    about = top.about[0].lower() + top.about[1:]
    out = [f'.TH {name.upper()} 1 "" "tp100 {version}" "User Commands"', ".SH NAME",
           f"{roff(name)} \\- {roff(about)}", ".SH SYNOPSIS"]
    for command in subcommands or [top]:
        out += [".B " + roff(command.usage), ".br"]
    out += table("OPTIONS", top.arguments())
    if subcommands:
        out.append(".SH COMMANDS")
    for command in subcommands:
        out += [f".SS {roff(command.usage)}", roff(command.about) + "."]
        out += table("", [row for row in command.arguments() if "--help" not in row[0]])
    out += [".SH EXAMPLES", ".nf"]
    out += [roff(example) for command in subcommands or [top] for example in command.examples] + [".fi"]
    out += table("EXIT STATUS", EXIT_STATUS) + table("FILES", FILES)
    others = [f".BR {roff(other)} (1)" for other in SEE_ALSO if other != name]
    return "\n".join(out + [".SH SEE ALSO"] + [line + " ," for line in others[:-1]] + others[-1:]) + "\n"


def main(program, version, folder):
    top, name = Command(program), os.path.basename(program)
    subcommands = [Command(program, subcommand) for subcommand, _ in top.parts["Subcommands:"]]
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, name + ".1.gz"), "wb") as file:
        # Without a time stamp, so that the same program gives the same bytes.
        file.write(gzip.compress(manual(name, top, subcommands, version).encode(), 9, mtime=0))


if __name__ == "__main__":
    main(*sys.argv[1:])
