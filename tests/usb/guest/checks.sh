# try NAME: runs the check of that name, which reports errors by `wrong`.
try() {
  check=$1
  failed=
  "check_$1"
  [ -n "$failed" ] || echo "ok $1"
  echo "$(cut -d ' ' -f 1 /proc/uptime) s"
}
# wrong WHAT: only the first error counts.
wrong() {
  [ -z "$failed" ] || return 1
  failed=$1
  echo "FAILED $check: $1"
  return 1
}
has() { grep -q -e "$2" "$1" || wrong "no '$2' in: $(tr '\n' '|' < "$1")"; }
lacks() { ! grep -q -e "$2" "$1" || wrong "'$2' is in: $(tr '\n' '|' < "$1")"; }
