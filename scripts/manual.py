#!/usr/bin/env python3
"""scripts/manual.py PROGRAM FOLDER: generates from PROGRAM's --help a man page (NAME.1.gz) and completion for bash
(NAME.bash) and zsh (_NAME) in FOLDER."""
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
# Possible values of an option, by the name of its value.
WORDS = {"SETUP": "stand flat terrain", "BOARD": "native avr", "MODEL": "paper extended odometry fused",
         "ENGINE": "parallel slurm one"}
BUNDLED = {"COURSE": "courses", "ROBOT": "robots"}


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
        self.examples = [line.removeprefix("Example: ") for line in lines if line.startswith("Example: ")]
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
        """Name of the first positional argument; empty: none."""
        if not self.positionals:
            return ""
        name, kind = (self.positionals[0][0].split() + [""])[:2]
        return name if kind == "TEXT" else kind


def commands_of(program):
    top = Command(program)
    return top, [Command(program, name) for name, _ in top.subcommands]


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
    examples = [example for command in subcommands or [top] for example in command.examples]
    if examples:
        out += [".SH EXAMPLES", ".nf", *map(roff, examples), ".fi"]
    out += table("EXIT STATUS", EXIT_STATUS) + table("FILES", FILES)
    others = [f".BR {roff(name)} (1)" for name in SEE_ALSO if name != top.name]
    return "\n".join(out + [".SH SEE ALSO"] + [line + " ," for line in others[:-1]] + others[-1:]) + "\n"


def bash_cases(prefix, command):
    kinds = {}
    for names, value, _ in command.arguments():
        if value:
            kinds.setdefault(value, []).extend(f"{prefix}:{name}" for name in names)
    for value, patterns in kinds.items():
        yield f"    {' | '.join(patterns)}) value={value} ;;"
    names = " ".join(name for names, _, _ in command.arguments() for name in names)
    yield f"    {prefix}:*) words='{names}' value={command.follows() or 'NONE'} ;;"


def bash(top, subcommands):
    function = "_" + top.name.replace("-", "_")
    names = " ".join(c.name for c in subcommands)
    out = [f"# bash completion for {top.name}, written by scripts/manual.py", f"{function}() {{",
           "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words='' value='' command=''"]
    if subcommands:
        out += ["  [ $COMP_CWORD -lt 2 ] || command=${COMP_WORDS[1]}", "  case $command:$before in",
                f"    :*) words='{names} --help --version' ;;"]
        for command in subcommands:
            out += bash_cases(command.name, command)
    else:
        out += ["  case $command:$before in", *bash_cases("", top)]
    out += ["  esac", "  [[ -z $words || $word == -* || $value == NONE || -z $value ]] || words=",
            "  case $value in"]
    out += [f"    {value}) words+=' {words}' ;;" for value, words in WORDS.items()]
    for value, folder in BUNDLED.items():
        out.append(f"    {value}) words+=\" $(cd /usr/share/tp100/{folder} 2>/dev/null && printf '%s ' *.toml |"
                   " sed 's/[.]toml / /g')\" ;;")
    out += ["  esac", "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")",
            "  [[ $word == -* ]] && return", "  case $value in",
            "    FILE | RUN | COURSE | ROBOT) mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -f -- \"$word\") ;;",
            "    FOLDER) mapfile -t COMPREPLY < <(compgen -d -- \"$word\") ;;",
            "    DEVICE) mapfile -t COMPREPLY < <(compgen -W \"auto $(compgen -G '/dev/tty[AU]*')"
            " $(compgen -G '/dev/tp100-*')\" -- \"$word\") ;;",
            "  esac", "}", f"complete -o filenames -F {function} {top.name}"]
    return "\n".join(out) + "\n"


def quoted(text, special="[]:\\"):
    for sign in "\\" + special.replace("\\", ""):
        text = text.replace(sign, "\\" + sign)
    return text.replace("'", "'\\''")


def zsh_action(value):
    if value in WORDS:
        return f"({WORDS[value]})"
    if value in BUNDLED:
        return "{ compadd -- /usr/share/tp100/" + BUNDLED[value] + "/*.toml(N\\:t\\:r); _files -g \"*.toml\" }"
    return {"FILE": "_files", "RUN": "_files", "FOLDER": "_files -/",
            "DEVICE": "{ compadd -- auto /dev/tty[AU]*(N) /dev/tp100-*(N) }"}.get(value, "")


def zsh_arguments(command):
    for names, value, text in command.arguments():
        for name in names:
            takes = f":{value}:{zsh_action(value)}" if value else ""
            yield f"'*{name}[{quoted(text)}]{takes}'"
    if command.follows():
        yield f"'*:{command.follows()}:{zsh_action(command.follows())}'"


def zsh(top, subcommands):
    def call(indent, command):
        return " \\\n".join([indent + "_arguments"] + [indent + "  " + each for each in zsh_arguments(command)])

    out = [f"#compdef {top.name}", "# Written by scripts/manual.py"]
    if not subcommands:
        return "\n".join(out + [call("", top)]) + "\n"
    out += ["local state", "local -a commands=("]
    out += [f"  '{c.name}:{quoted(c.about, ':')}'" for c in subcommands]
    out += [")", "_arguments -C '--help[Say how to use it]' '--version[Say which version it is]' "
            "'1:command:->command' '*::argument:->rest'", "case $state in",
            "  command) _describe command commands ;;", "  rest)", "    case $words[1] in"]
    for command in subcommands:
        out += [f"      {command.name})", call("        ", command), "        ;;"]
    return "\n".join(out + ["    esac", "    ;;", "esac"]) + "\n"


def main(program, folder):
    top, subcommands = commands_of(program)
    version = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout.strip()
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, top.name + ".1.gz"), "wb") as file:
        # Without a time stamp, so that the same program gives the same bytes.
        file.write(gzip.compress(manual(top, subcommands, version).encode(), 9, mtime=0))
    for name, text in ((top.name + ".bash", bash(top, subcommands)), ("_" + top.name, zsh(top, subcommands))):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("manual.py: give a program and a folder; see the top of the file")
    main(*sys.argv[1:])
