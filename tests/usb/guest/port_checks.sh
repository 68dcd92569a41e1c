# Ports that tp100d finds, and how it opens them. Board 0 stays plugged in, as ttyACM0, and no daemon is left running.

check_lists_ports() {
  until_ test -c /dev/ttyUSB0 || wrong "no /dev/ttyUSB0"
  plug 0
  tp100d ports > /tmp/ports
  sed -n 1p /tmp/ports > /tmp/first
  has /tmp/first "^/dev/ttyACM0  2341:0042  Arduino Mega 2560, serial TP100A$"
  has /tmp/ports '^    port = "/dev/serial/by-id/usb-Arduino-TP100A-if00"$'
  has /tmp/ports "^/dev/ttyUSB0  0403:6001  FTDI bridge"
  has /tmp/ports "^    auto skips it: not the only candidate (FTDI bridge); if it is the robot, name it"
  has /tmp/ports "^/dev/ttyS1  -  serial port$"
}

unplug_bridge() {
  modprobe -r ftdi_sio
  until_ test ! -e /dev/ttyUSB0 || wrong "the bridge is still there"
}
plug_bridge() {
  modprobe ftdi_sio
  until_ test -c /dev/ttyUSB0 || wrong "no /dev/ttyUSB0"
}

# tp100d must open none of two boards; if there is one, it must find it without help and drive a short course.
check_drives() {
  start_course --port auto
  await "auto skips /dev/ttyACM0: not the only candidate (Arduino Mega 2560); /dev/ttyUSB0: not the only" && ended 2
  unplug_bridge
  start_course --port auto
  await "/dev/ttyACM0: open" && ready && drive_it
  plug_bridge
}

# The port must be raw and at 500000 baud, as the bus shows. The next checks use the record of DTR.
check_sets_the_port() {
  unplug 0
  plug 0
  watch_bus
  start --port /dev/ttyACM0
  ready
  stty -a < /dev/ttyACM0 > /tmp/stty 2> /dev/null
  for word in " cs8 " "-parenb" "-cstopb" "-crtscts" "-hupcl" " clocal" "-icanon" "-echo " "-isig" \
    "-opost" "-ixon" "-icrnl"; do
    has /tmp/stty "$word"
  done
  # SET_LINE_CODING: 500000 baud, 1 stop bit, no parity, 8 data bits.
  has /tmp/bus "s 21 20 0000 0000 0007 7 = 20a10700 000008"
}

# This check continues with the daemon of the previous one.
check_is_alone_on_it() {
  tp100d run --listen off --port /dev/ttyACM0 > /tmp/second 2>&1 < /dev/null
  status=$?
  [ $status = 2 ] || wrong "a second tp100d ended with status $status, not 2"
  has /tmp/second "/dev/ttyACM0: port is busy, held by tp100d (pid $daemon)"
  [ "$(wc -l < /tmp/second)" = 1 ] || wrong "a second tp100d said more than one line: $(tr '\n' '|' < /tmp/second)"
  # The kernel refuses other users access.
  chmod 666 /dev/ttyACM0
  su nobody -c "head -c 1 /dev/ttyACM0" > /tmp/other 2>&1
  has /tmp/other "busy"
  su nobody -c "tp100d run --listen off --port /dev/ttyACM0" > /tmp/other 2>&1 < /dev/null
  has /tmp/other "/dev/ttyACM0: port is busy, held by a program of another account"
  # Only the lock refuses root access; a second daemon must not change the settings of the port either.
  stty -a < /dev/ttyACM0 2> /dev/null | cmp -s - /tmp/stty || wrong "a second tp100d changed the settings of the port"
  ! says "ready -> " || wrong "the first tp100d lost its robot: $(last_words)"
}

# leaves_the_lines STATE: stops the daemon and reads the last SET_CONTROL_LINE_STATE; 0003: both lines are up.
leaves_the_lines() {
  stop
  kill $bus
  grep "s 21 22" /tmp/bus | tail -n 1 > /tmp/last
  has /tmp/last "s 21 22 $1"
}

# Closing the port must leave both lines up, so that the next opening resets no board.
check_keeps_dtr() {
  leaves_the_lines 0003
}

check_drops_dtr() {
  printf '[link]\nhang_up = true\n' > /tmp/hang_up.toml
  watch_bus
  start --port /dev/ttyACM0 --config /tmp/hang_up.toml
  ready
  leaves_the_lines 0000
}

# The bridge must be configured not to delay bytes.
check_low_latency() {
  timer=/sys/class/tty/ttyUSB0/device/latency_timer
  echo 16 > $timer
  start --port /dev/ttyUSB0 --wait
  await "closed -> listening"
  [ "$(cat $timer)" = 1 ] || wrong "$timer is $(cat $timer), not 1"
  stop
  tp100d doctor --port /dev/ttyUSB0 > /tmp/doctor 2>&1 < /dev/null
  has /tmp/doctor "^ok *latency-timer *1 ms"
}

check_doctor() {
  control=$(realpath /sys/class/tty/ttyACM0/device/..)/power/control
  echo auto > $control
  tp100d doctor --port /dev/ttyACM0 > /tmp/doctor 2>&1 < /dev/null
  has /tmp/doctor "autosuspend.*$control is auto"
  has /tmp/doctor "Arduino Mega 2560, serial TP100A"
  echo on > $control
}
