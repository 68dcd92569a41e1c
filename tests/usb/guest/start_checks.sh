# The robot of board 0, plugged in as ttyACM0, under other names: nothing moves before Enter. After Enter it drives the
# course to its end, which requires the right speed of the wire.

# waits_on PORT: checks that there is no start and no motion before Enter.
waits_on() {
  before=$(motors_off 0 disarm)
  start_course --port $1
  ready && await "press Enter to start"
  sleep 3
  ! says "-> arming" || wrong "tp100d armed the robot on $1 by itself: $(last_words)"
  [ "$(motors_off 0 disarm)" = $before ] || wrong "the robot on $1 had its motors on"
  drive_it
}

# node NAME: makes another device node for the robot's port.
node() { mknod $1 c $(tr : ' ' < /sys/class/tty/ttyACM0/dev); }

check_waits_under_another_name() {
  node /tmp/twin
  waits_on /tmp/twin
  rm /tmp/twin
  node /dev/robot
  waits_on /dev/robot
  rm /dev/robot
}

check_waits_behind_a_link() {
  ln -s /dev/ttyACM0 /tmp/linked
  waits_on /tmp/linked
  node /tmp/twin
  ln -sf /tmp/twin /tmp/linked
  waits_on /tmp/linked
  rm /tmp/linked /tmp/twin
}

# The root folder has no /sys, and its /dev contains only the given nodes.
check_waits_in_a_container() {
  mkdir -p /jail
  mount --bind / /jail
  mount -t tmpfs dev /jail/dev
  mount -t tmpfs sys /jail/sys
  mount -t proc proc /jail/proc
  root=/jail
  for name in robot ttyACM0; do
    node /jail/dev/$name
    waits_on /dev/$name
  done
  root=
  umount /jail/proc /jail/sys /jail/dev /jail
}
