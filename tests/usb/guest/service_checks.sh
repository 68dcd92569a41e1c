# Each of these checks continues with the service tp100d@tp100 of the previous one.
journal() { journalctl --no-pager -o cat -u ${1:-$unit}; }
journal_says() { journal "$2" | grep -q -e "$1"; }
hears() {
  for at in $(seq $((patience * 2))); do
    journal_says "$1" && return
    sleep 0.5
  done
  wrong "$unit did not say '$1' but: $(journal | tail -n 12 | tr '\n' '|')"
}
ask() { systemctl show -P "$1" ${2:-$unit}; }
main_pid() { ask MainPID; }
is() { # WHAT WANTED GOT
  [ "$2" = "$3" ] || wrong "$1 is '$3', not '$2'"
}

check_starts_without_a_board() {
  lacks /proc/devices "ttyACM\|ttyUSB"
  # dpkg installs in the same order: first the files, then postinst.
  cp /guest/65-tp100.rules /lib/udev/rules.d
  sh /guest/postinst configure || wrong "postinst ended with status $?"
  udevadm settle
  systemctl start $unit || wrong "it does not start: $(journal | tr '\n' '|')"
  has /proc/devices "ttyACM"
  has /proc/devices "ttyUSB"
  hears "/dev/tp100-TP100A: no such port.*waiting"
}

check_finds_the_board_plugged_in_later() {
  modprobe -a libcomposite usb_f_acm
  modprobe dummy_hcd num=2
  until_ test -d $gadgets || mount -t configfs configfs /sys/kernel/config
  make_board 0 TP100A
  make_robot 0
  echo dummy_udc.0 > $gadgets/board0/UDC
  hears "/dev/tp100-TP100A: open"
  hears "syncing -> ready"
  is NRestarts 0 "$(ask NRestarts)"
}

# The service must run as its user, in the real-time class, with its memory locked and the processor kept awake.
check_has_its_rights() {
  pid=$(main_pid)
  is "its user" tp100 "$(stat -c %U /proc/$pid)"
  hears "real time: SCHED_FIFO 80"
  hears "real time: memory locked"
  hears "real time: processor kept awake"
  # Fields 40 and 41 of proc(5), counted from the name, must be priority 80 and policy SCHED_FIFO, which is 1.
  cat /proc/$pid/task/*/stat | sed 's/.*) //' | cut -d ' ' -f 38,39 > /tmp/policies
  has /tmp/policies "^80 1$"
  locked_kb=$(sed -n 's/^VmLck:[^0-9]*\([0-9]*\) kB$/\1/p' /proc/$pid/status)
  [ "${locked_kb:-0}" -gt 4096 ] || wrong "only $locked_kb kB of its memory are locked"
  ls -l /proc/$pid/fd > /tmp/open
  has /tmp/open "/dev/cpu_dma_latency$"
  has /tmp/open "/dev/ttyACM0$"
  sed -n 's/^CapEff:[^0-9]*//p' /proc/$pid/status > /tmp/capabilities
  has /tmp/capabilities "^0*$"
  # The boot id tells whether a camera's stamps are on this machine's clock.
  is "the boot id that it sees" "$(cat /proc/sys/kernel/random/boot_id)" \
    "$(cat /proc/$pid/root/proc/sys/kernel/random/boot_id 2>&1)"
}

# The service may open only the ports that the unit names, even if their mode allows more.
check_is_kept_from_other_ports() {
  chgrp dialout /dev/ttyS1
  chmod 660 /dev/ttyS1
  systemctl start tp100d@other
  refused() { journal_says "/dev/ttyS1: .*ermi" tp100d@other; }
  until_ refused || wrong "tp100d@other on /dev/ttyS1: $(journal tp100d@other | tail -n 5 | tr '\n' '|')"
  systemctl stop tp100d@other
}

node() { stat -c '%U:%G %a' "$1"; }
check_board_is_prepared() {
  is /dev/ttyACM0 "root:dialout 660" "$(node /dev/ttyACM0)"
  is /dev/cpu_dma_latency "root:tp100 660" "$(node /dev/cpu_dma_latency)"
  is /dev/tp100-TP100A /dev/ttyACM0 "$(realpath /dev/tp100-TP100A)"
  usb=$(realpath /sys/class/tty/ttyACM0/device/..)
  is "$usb/power/control" on "$(cat $usb/power/control)"
  udevadm info /dev/ttyACM0 > /tmp/port
  has /tmp/port "ID_MM_PORT_IGNORE=1"
  has /tmp/port "TAGS=.*:uaccess:"
  udevadm info $usb > /tmp/usb
  lacks /tmp/usb "ID_MM_DEVICE_IGNORE"
}

# The bridge may belong to another device, for which the administrator has a rule.
check_bridge_is_left_alone() {
  printf 'SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", GROUP="tty", MODE="0640"\n' > /etc/udev/rules.d/60-meter.rules
  udevadm control --reload
  rm /etc/modprobe.d/later.conf
  modprobe ftdi_sio
  until_ test -e /dev/ttyUSB0 || wrong "no /dev/ttyUSB0"
  udevadm settle
  is /dev/ttyUSB0 "root:tty 640" "$(node /dev/ttyUSB0)"
  # The emulated bridge has no latency timer: the driver reads 0.
  is "latency timer" 0 "$(cat /sys/class/tty/ttyUSB0/device/latency_timer)"
  udevadm info /dev/ttyUSB0 > /tmp/port
  lacks /tmp/port "ID_MM_\|uaccess"
  rm /etc/udev/rules.d/60-meter.rules
}

# The rule file describes these steps.
check_bridge_is_prepared_when_asked() {
  cp /guest/64-tp100-bridges.rules /etc/udev/rules.d
  udevadm control --reload && udevadm trigger --subsystem-match=usb --subsystem-match=tty
  udevadm settle
  is "latency timer" 1 "$(cat /sys/class/tty/ttyUSB0/device/latency_timer)"
  usb=$(realpath /sys/class/tty/ttyUSB0/device/../..)
  is "$usb/power/control" on "$(cat $usb/power/control)"
  udevadm info /dev/ttyUSB0 > /tmp/port
  has /tmp/port "ID_MM_PORT_IGNORE=1"
  has /tmp/port "TAGS=.*:uaccess:"
}

drop_in() {
  mkdir -p /run/systemd/system/$unit.service.d
  printf '[Service]\n%s\n' "$@" > /run/systemd/system/$unit.service.d/test.conf
  systemctl daemon-reload
}

# This must hold even with --go: otherwise the robot would start again whenever systemd restarts the service.
check_starts_nothing_by_itself() {
  started=$(grep '^ExecStart=' /lib/systemd/system/tp100d@.service)
  drop_in "ExecStart=
$started --go"
  systemctl restart $unit
  asked_before=$(journal | grep -c "press Enter to start course")
  kill -9 $(main_pid)
  again() { [ "$(ask NRestarts)" -ge 1 ] && [ "$(journal | grep -c "press Enter to start course")" -gt $asked_before ]; }
  until_ again || wrong "NRestarts $(ask NRestarts): $(journal | tail -n 5 | tr '\n' '|')"
  sleep 5
  ! journal_says "-> arming" || wrong "the service started a run by itself"
}

# The page does the same: it calls the service `start` of foxglove.websocket.v1.
press_start() {
  {
    printf 'GET / HTTP/1.1\r\nHost: 127.0.0.1:8765\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n'
    printf 'Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n'
    printf 'Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n\r\n'
    sleep 2
    printf '\202\223\000\000\000\000\002\001\000\000\000\001\000\000\000\004\000\000\000json{}'
    sleep 2
  } | socat - TCP:127.0.0.1:8765 > /tmp/page
}

check_drives_as_the_service() {
  press_start
  hears "running -> finished"
  hears "info completed"
}
