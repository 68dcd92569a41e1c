# Boards that are unplugged. Before and after each check, only board 0 is plugged in, as ttyACM0.

# Before tp100d knows its robot, it needs --wait.
check_unplugged_while_joining() {
  touch /tmp/cut0
  unplug 0
  plug 0
  start_course --port /dev/ttyACM0 --wait
  await "closed -> listening"
  mark
  unplug 0
  await "port is gone"
  rm /tmp/cut0
  for state in "listening -> parameters" "parameters -> syncing"; do
    mark
    plug 0
    await "$state"
    unplug 0
    await "port is gone"
  done
  mark
  plug 0
  ready && drive_it
}

check_unplugged_while_ready() {
  start_course --port /dev/ttyACM0
  ready
  for time in 1 2; do
    mark
    unplug 0
    await "port is gone"
    plug 0
    ready
  done
  drive_it
}

check_unplugged_while_driving() {
  start_course --port /dev/ttyACM0
  await "press Enter" && press_enter
  for state in "idle -> arming" "arming -> running"; do
    await "$state"
    mark
    unplug 0
    await "port is gone"
    plug 0
    ready && await "type go"
    # The robot was driving before. Without a new start it must stay still, and Enter is no start.
    sleep 1
    press_enter
    sleep 1
    ! says "-> arming" || wrong "tp100d armed the robot by itself: $(last_words)"
    mark
    type_go
  done
  await "short: completed"
  ended 0
}

# holds PID FILE: true if that program reads from FILE.
holds() { [ "$(readlink /proc/$1/fd/0)" = "$2" ]; }

# Another program still has the old number open. In the meantime no other port may be tried, because the robot is known.
check_returns_under_another_number() {
  printf '[link]\nfirst_frame_timeout_ms = 500.0\n' > /tmp/quick.toml
  unplug_bridge
  start_course --port auto --config /tmp/quick.toml
  ready
  plug_bridge
  sleep 100000 < /dev/ttyACM0 &
  holder=$!
  until_ holds $holder /dev/ttyACM0 || wrong "nobody else has /dev/ttyACM0 open"
  mark
  unplug 0
  await "port is gone"
  plug 0 1
  await "/dev/ttyACM1: open" && ready
  ! says "ttyUSB0: open" || wrong "the bridge was asked, too: $(last_words 20)"
  drive_it
  kill $holder
  unplug 0
  plug 0
}

check_two_boards() {
  make_robot 1
  plug 1 1
  tp100d ports > /tmp/ports
  has /tmp/ports "^/dev/ttyACM0 .* serial TP100A$"
  has /tmp/ports "^/dev/ttyACM1 .* serial TP100B$"
  before="$(motors_off 0 disarm) $(motors_off 1 disarm)"
  start_course --port /dev/serial/by-id/usb-Arduino-TP100B-if00
  ready && drive_it
  now="$(motors_off 0 disarm) $(motors_off 1 disarm)"
  [ "$before $now" = "${before% *} ${before#* } ${before% *} $((${before#* } + 1))" ] ||
    wrong "A and B were disarmed $before times before the drive of B, $now times after it"
}

# This check continues with the boards of the previous one: the same name now leads to the other number.
check_two_boards_change_numbers() {
  start --wait --port /dev/serial/by-id/usb-Arduino-TP100B-if00
  ready
  mark
  unplug 0
  unplug 1
  await "port is gone"
  plug 1 0
  plug 0 1
  ready
  ls -l /proc/$daemon/fd > /tmp/open
  has /tmp/open "/dev/ttyACM0$"
  stop
  unplug 0
  unplug 1
  plug 0
}
