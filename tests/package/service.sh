# Runs in the installed machine under systemd, as root. Ends with "service: done".
set -e
unit=tp100d@tp100
wait_for() { # COMMAND...: until it succeeds, for 30 s
  { set +x; } 2>/dev/null
  for _ in $(seq 300); do
    if "$@" >/dev/null 2>&1; then
      set -x
      return 0
    fi
    sleep 0.1
  done
  echo "service: waited in vain for: $*"
  journalctl --no-pager -u $unit
  exit 1
}
refused() { # UNIT: cannot be started
  if systemctl start "$1"; then
    echo "service: $1 has started"
    exit 1
  fi
}
said() { journalctl --no-pager -o cat -u $unit | grep -q "$1"; }
status() { systemctl show -P StatusText $unit | grep -q "$1"; }

if [ -z "@MAY_RAISE@" ]; then
  # Root may not raise limits here: LimitRTPRIO, LimitMEMLOCK and PrivateUsers are left to usb.service.
  mkdir -p /run/systemd/system/$unit.service.d
  printf '[Service]\nPrivateUsers=no\nCapabilityBoundingSet=CAP_SYS_NICE\nAmbientCapabilities=CAP_SYS_NICE\n' \
    >/run/systemd/system/$unit.service.d/test.conf
  systemctl daemon-reload
fi

setpriv --reuid=tp100 --regid=tp100 --init-groups tp100-sim robot --link /tmp/robot &
robot=$!
wait_for test -e /tmp/robot
# The service has its own /tmp.
ln -sfn "$(readlink /tmp/robot)" /srv/robot

systemctl enable --now $unit
test "$(systemctl is-active $unit)" = active
status 'page http://127.0.0.1:8765/'
said 'real time: SCHED_FIFO 80'
[ -z "@MAY_RAISE@" ] || said 'real time: memory locked'
wait_for status 'link ready'
# A service must not start a run without a request.
sleep 1
status 'run idle'
# The boot id, which tells whether a camera's stamps are on this machine's clock. The container has its own file for it.
grep -q . "/proc/$(systemctl show -P MainPID $unit)/root/proc/sys/kernel/random/boot_id"

# A daemon whose loop hangs must be replaced.
kill -STOP "$(systemctl show -P MainPID $unit)"
restarted() { [ "$(systemctl show -P NRestarts $unit)" = 1 ] && [ "$(systemctl is-active $unit)" = active ]; }
wait_for restarted
said 'Watchdog timeout'

# A failure that a restart may fix must lead to a restart.
systemctl stop $unit
starved=tp100d@starved
printf '[server]\nlisten = "off"\n' >/etc/tp100/starved.toml
mkdir -p /run/systemd/system/$starved.service.d
printf '[Service]\nLimitNOFILE=6\n' >/run/systemd/system/$starved.service.d/files.conf
systemctl daemon-reload
systemctl start $starved || true
again() { [ "$(systemctl show -P NRestarts $starved)" -ge 1 ]; }
wait_for again
journalctl --no-pager -o cat -u $starved | grep -q 'stopped: .*; start it again'
systemctl stop $starved
rm -r /etc/tp100/starved.toml /run/systemd/system/$starved.service.d

# ROS 2 needs more than the unit allows; with the drop-in of ROS2.md it works, and uses no more than that.
topics=tp100d@topics
printf '[link]\nport = "/srv/robot"\n[ros2]\nenabled = true\n' >/etc/tp100/topics.toml
refused $topics
journalctl --no-pager -o cat -u $topics | grep -F '[ros2]: cannot join domain 0'
mkdir -p /run/systemd/system/$topics.service.d
printf '[Service]\n@ROS2_DROP_IN@\n' >/run/systemd/system/$topics.service.d/ros2.conf
systemctl daemon-reload
systemctl start $topics
# A listener on the port of a second participant of domain 0 receives announcements (RTPS 2.2, 9.6.1).
announced() {
  timeout 2 perl -MSocket -e 'socket(S, PF_INET, SOCK_DGRAM, 0) and bind(S, sockaddr_in(7412, INADDR_LOOPBACK)) and
    recv(S, $message, 4, 0) // die; exit($message ne "RTPS")'
}
wait_for announced
systemctl stop $topics
rm -r /etc/tp100/topics.toml /run/systemd/system/$topics.service.d

# An error in a file must be reported once, without a restart.
echo 'robto = "uniform"' >/etc/tp100/wrong.toml
refused tp100d@wrong
test "$(systemctl show -P NRestarts tp100d@wrong)" = 0
rm /etc/tp100/wrong.toml
refused tp100d@none

# Removing the package must stop the running service.
systemctl start $unit
dpkg --remove tp100
test "$(systemctl is-active $unit)" = inactive
dpkg --install /srv/tp100.deb
kill $robot
echo "service: done"
