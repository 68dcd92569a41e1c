#!/usr/bin/env python3
"""scripts/manual.py PROGRAM FOLDER: writes into FOLDER what PROGRAM's --help says, as a man page (NAME.1.gz) and as
completion for bash (NAME.bash) and zsh (_NAME)."""
import gzip
import os
import subprocess
import sys

from manual_help import commands_of
from manual_shells import bash, zsh

EXIT_STATUS = (("0", "done, and within limits"), ("1", "the run failed or broke a limit"),
               ("2", "bad usage, a bad file, or a port that is missing or busy"),
               ("3", "stopped by want of memory or a defect; report it if it comes back"))
FILES = (("/etc/tp100/NAME.toml", "configuration of the service tp100d@NAME"),
         ("/usr/share/tp100", "courses, robots and cameras by name, every key of the configuration, and the firmware"),
         ("/var/lib/tp100/NAME", "what the service writes: the seconds around a fault"))
SEE_ALSO = ("tp100d", "tp100-camera", "tp100-campaign", "tp100-flash", "tp100-sim")


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text[:1] in (".", "'") else text


def table(title, rows):
    out = [f".SH {title}"] if title else []
    for left, text in rows:
        out += [".TP", f".B {roff(left)}", roff(text)]
    return out


def manual(top, subcommands, version):
    about = top.about[0].lower() + top.about[1:]
    out = [f'.TH {top.name.upper()} 1 "" "tp100 {version}" "User Commands"', ".SH NAME",
           f"{roff(top.name)} \\- {roff(about)}", ".SH SYNOPSIS"]
    for command in subcommands or [top]:
        out += [".B " + roff(command.usage), ".br"]
    out += table("OPTIONS", top.positionals + top.options)
    if subcommands:
        out.append(".SH COMMANDS")
    for command in subcommands:
        out += [f".SS {roff(command.usage)}", roff(command.about) + "."]
        out += table("", command.positionals + [row for row in command.options if "--help" not in row[0]])
    out += table("EXIT STATUS", EXIT_STATUS) + table("FILES", FILES)
    others = [f".BR {roff(name)} (1)" for name in SEE_ALSO if name != top.name]
    return "\n".join(out + [".SH SEE ALSO"] + [line + " ," for line in others[:-1]] + others[-1:]) + "\n"


def main(program, folder):
    top, subcommands = commands_of(program)
    version = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout.strip()
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, top.name + ".1.gz"), "wb") as file:
        # Without a time the same program gives the same bytes.
        file.write(gzip.compress(manual(top, subcommands, version).encode(), 9, mtime=0))
    for name, text in ((top.name + ".bash", bash(top, subcommands)), ("_" + top.name, zsh(top, subcommands))):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("manual.py: give a program and a folder; see the top of the file")
    main(*sys.argv[1:])
