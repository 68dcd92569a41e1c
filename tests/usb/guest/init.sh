#!/bin/sh
# The first process of the machine: it prepares the machine, runs the checks and switches the machine off.
/bin/busybox --install -s /bin
export PATH=/bin HOME=/tmp XDG_STATE_HOME=/tmp
mount -t devtmpfs dev /dev
mkdir -p /dev/pts
mount -t devpts pts /dev/pts
mount -t proc proc /proc
mount -t sysfs sys /sys
mount -t debugfs debug /sys/kernel/debug
exec < /dev/null > /dev/ttyS0 2>&1
modprobe -a libcomposite usb_f_acm cdc_acm xhci_pci ftdi_sio usbmon configfs
modprobe dummy_hcd num=2
mount -t configfs configfs /sys/kernel/config
echo "nobody:x:65534:65534::/tmp:/bin/sh" > /etc/passwd
ip link set lo up
chmod 1777 /tmp
. /guest/checks.sh
. /guest/board.sh
. /guest/daemon.sh
. /guest/port_checks.sh
. /guest/plug_checks.sh
. /guest/start_checks.sh
. /guest/auto_checks.sh

make_board 0 TP100A
make_board 1 TP100B
make_robot 0

try lists_ports
try drives
try sets_the_port
try is_alone_on_it
try keeps_dtr
try drops_dtr
try low_latency
try doctor
try waits_under_another_name
try waits_behind_a_link
try waits_in_a_container
try unplugged_while_joining
try unplugged_while_ready
try unplugged_while_driving
try returns_under_another_number
try two_boards
try two_boards_change_numbers
try leaves_what_others_have_open
try leaves_a_bridge_that_others_have_open

echo "guest: done"
poweroff -f
