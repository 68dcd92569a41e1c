"""Completion for bash and zsh, for scripts/manual.py."""
# What may follow an option, by the name of its value.
WORDS = {"SETUP": "stand flat terrain", "BOARD": "native avr", "MODEL": "paper extended odometry fused",
         "ENGINE": "parallel slurm one"}
BUNDLED = {"COURSE": "courses", "ROBOT": "robots"}


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
