# Completion for bash of tp100d, tp100-sim and the other programs: offers what their --help lists, and files.
_tp100() {
  local word=$2 before=$3 command='' help kind words=''
  [[ $COMP_CWORD -lt 2 || ${COMP_WORDS[1]} == -* ]] || command=${COMP_WORDS[1]}
  help=$("$1" ${command:+"$command"} --help 2>/dev/null) || return
  # What belongs here: the value of the option before, or else the first positional argument.
  kind=$(awk -v option="$before" '
    /^[A-Z]/ { part = $1 }
    /^  -/ { split($1, names, ","); for (i in names) if (names[i] == option) value = $2 }
    /^  [A-Z]/ && part == "Positionals:" && !positional { positional = $1 }
    END { sub(/[:=].*/, "", value); print value ? value : positional }' <<<"$help")
  if [[ $word == -* ]]; then
    words=$(sed -nE 's/^  (-.,)?(--[a-z0-9-]+).*/\2/p' <<<"$help")
  elif [[ -z $command ]] && grep -q '^Subcommands:' <<<"$help"; then
    words=$(sed -n '/^Subcommands:/,$s/^  \([a-z]*\) .*/\1/p' <<<"$help")
  else
    case $kind in
      SETUP) words='stand flat terrain' ;;
      BOARD) words='native avr' ;;
      BODY) words='ode shear' ;;
      FLOOR) words='even uneven' ;;
      ENGINE) words='parallel slurm one' ;;
      COURSE | ROBOT) words=$(ls /usr/share/tp100/"${kind,,}s" 2>/dev/null | sed 's/[.]toml$//') ;;
      DEVICE) words="auto $(compgen -G '/dev/tty[AU]*') $(compgen -G '/dev/tp100-*')" ;;
    esac
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -o default -F _tp100 tp100d tp100-sim tp100-camera tp100-flash tp100-campaign
