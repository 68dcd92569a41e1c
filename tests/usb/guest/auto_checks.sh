# Ports that another program has opened as pyserial does: without a lock and at its own speed. Before and after each
# check, only board 0 is plugged in, as ttyACM0.

# work_with PORT: opens PORT at 115200 baud and sets $holder.
work_with() {
  (
    stty 115200 raw -echo
    exec sleep 100000
  ) < $1 &
  holder=$!
  until_ works_at $1 115200 || wrong "$1 is not at 115200"
}
works_at() { stty < $1 | grep -q "speed $2 baud"; }

# The bus is quiet if no speed and no DTR is set on a Mega or on the FTDI bridge.
bus_was_quiet() {
  kill $bus
  lacks /tmp/bus " s 21 2[02] "
  lacks /tmp/bus " s 40 0[0134] "
}

check_leaves_what_others_have_open() {
  unplug 0
  plug 1
  work_with /dev/ttyACM0
  printer=$holder
  work_with /dev/ttyUSB0
  watch_bus
  start_course --wait
  await "auto skips /dev/ttyACM0: held open by sleep (pid $printer)"
  sleep 60
  ! says ": open" || wrong "tp100d opened somebody's port: $(last_words)"
  bus_was_quiet
  works_at /dev/ttyACM0 115200 || wrong "the other Mega is at: $(stty < /dev/ttyACM0 | head -n 1)"
  works_at /dev/ttyUSB0 115200 || wrong "the bridge is at: $(stty < /dev/ttyUSB0 | head -n 1)"
  # The robot is plugged in: only a person knows that it is not the board that somebody has open.
  plug 0 1
  await "/dev/ttyACM1: not the only candidate"
  stop
  start_course --port /dev/ttyACM1
  ready
  works_at /dev/ttyACM0 115200 || wrong "the other Mega is at: $(stty < /dev/ttyACM0 | head -n 1)"
  drive_it
  kill $printer $holder
  unplug 0
  unplug 1
  plug 0
}

check_leaves_a_bridge_that_others_have_open() {
  unplug 0
  work_with /dev/ttyUSB0
  watch_bus
  start --wait
  await "auto skips /dev/ttyUSB0: held open by sleep (pid $holder)"
  sleep 20
  bus_was_quiet
  works_at /dev/ttyUSB0 115200 || wrong "the bridge is at: $(stty < /dev/ttyUSB0 | head -n 1)"
  # Once the bridge is free, it must be tried once.
  kill $holder
  await "/dev/ttyUSB0: open" && await "auto ignores it until it is plugged in again"
  mark
  sleep 15
  ! says ": open" || wrong "the bridge was asked again: $(last_words)"
  stop
  # A user who cannot see the programs of others must leave the bridge alone.
  chmod 666 /dev/ttyUSB0
  su nobody -c "tp100d run --listen off" > /tmp/other 2>&1 < /dev/null
  has /tmp/other "auto skips /dev/ttyUSB0: this account cannot see whether another program has it open (FTDI bridge)"
  plug 0
}
