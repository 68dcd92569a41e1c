# Functions for the real tp100d and its output. The patience is in seconds of this machine, in which nothing is ever
# late.
patience=30

# until_ COMMAND...: waits until COMMAND succeeds; false if it does not in time.
until_() {
  for at in $(seq $((patience * 10))); do
    "$@" && return
    sleep 0.1
  done
  return 1
}

mkfifo /tmp/keys
exec 9<> /tmp/keys
press_enter() { echo >&9; }
type_go() { echo go start >&9; }

# start ARGUMENTS...: runs tp100d run in the background, with the folder $root as its root if that is set.
start() {
  : > /tmp/daemon.log
  said_before=0
  ${root:+chroot $root} tp100d run --listen off "$@" < /tmp/keys > /tmp/daemon.log 2>&1 &
  daemon=$!
}
# From here on, only new output counts.
mark() { said_before=$(wc -l < /tmp/daemon.log); }
since_mark() { tail -n +$((said_before + 1)) /tmp/daemon.log; }
says() { since_mark | grep -q -e "$1"; }
last_words() { tail -n ${1:-8} /tmp/daemon.log | tr '\n' '|'; }
# await TEXT: waits until the output contains TEXT.
await() { until_ says "$1" || wrong "tp100d did not say '$1' but: $(last_words)"; }
ready() { await "syncing -> ready"; }
has_ended() { ! kill -0 $daemon 2> /dev/null; }
# ended STATUS: waits until the program has ended by itself with that status.
ended() {
  until_ has_ended || { wrong "tp100d did not end"; kill -9 $daemon; }
  wait $daemon
  status=$?
  [ $status = "$1" ] || wrong "tp100d ended with status $status: $(last_words)"
}
stop() {
  kill -INT $daemon
  # The status of an interrupted program is 1.
  ended 1
}

cat > /tmp/short.toml << 'COURSE'
description = "short"
speed_mps = 0.1
[[segment]]
type = "line"
length_m = 0.1
[fence]
min_x_m = -0.5
max_x_m = 0.8
min_y_m = -0.5
max_y_m = 0.5
COURSE
start_course() { start --course /tmp/short.toml "$@"; }
# drive_it: presses Enter and waits for the end of the course.
drive_it() {
  await "press Enter" && press_enter
  await "short: completed"
  ended 0
}
