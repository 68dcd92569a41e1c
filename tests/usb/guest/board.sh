# Boards on USB: each is an Arduino Mega 2560 made by the kernel's gadget driver, connected to an emulated robot.
gadgets=/sys/kernel/config/usb_gadget

# make_board N SERIAL: makes a board that is not plugged in yet.
make_board() {
  g=$gadgets/board$1
  mkdir $g $g/strings/0x409 $g/configs/c.1 $g/functions/acm.$1
  echo 0x2341 > $g/idVendor
  echo 0x0042 > $g/idProduct
  echo 2 > $g/bDeviceClass
  echo "Arduino (www.arduino.cc)" > $g/strings/0x409/manufacturer
  echo "Mega 2560" > $g/strings/0x409/product
  echo "$2" > $g/strings/0x409/serialnumber
  ln -s $g/functions/acm.$1 $g/configs/c.1
}

# plug N [NUMBER]: plugs board N in, as /dev/ttyACMNUMBER or with the first free number.
plug() {
  echo "dummy_udc.$1" > $gadgets/board$1/UDC
  until_ test -c /dev/ttyACM${2:-0} || wrong "board $1 is plugged in, but there is no /dev/ttyACM${2:-0}"
  name_ports
}
unplug() {
  echo > $gadgets/board$1/UDC
  until_ sh -c "! ls /sys/devices/platform/dummy_hcd.$1/usb*/*-1/idVendor" > /dev/null 2>&1 ||
    wrong "board $1 is unplugged, but Linux still has it"
}

# Makes the links that udev would make.
name_ports() {
  rm -rf /dev/serial
  mkdir -p /dev/serial/by-id
  for tty in /sys/class/tty/ttyACM*; do
    [ -e $tty ] || continue
    ln -s ../../${tty##*/} /dev/serial/by-id/usb-Arduino-$(cat $tty/device/../serial)-if00
  done
}

# make_robot N: starts a robot that board N powers. When the board is plugged in, the robot's wire is opened, which
# resets the robot. While the file /tmp/cutN exists, the robot is disconnected from the board.
make_robot() {
  tp100-sim robot --link /tmp/robot$1 > /tmp/robot$1.log 2>&1 &
  while :; do
    if [ "$(cat /sys/class/udc/dummy_udc.$1/state)" = configured ] && [ ! -e /tmp/cut$1 ]; then
      socat /dev/ttyGS$1,raw,echo=0 /tmp/robot$1,raw,echo=0
    fi
    sleep 0.05
  done 2> /dev/null &
}
# motors_off N REASON: counts how often robot N switched its motors off for REASON.
motors_off() { grep -c "motors off: $2" /tmp/robot$1.log; }

# watch_bus: records the requests on the bus until $bus is killed.
watch_bus() {
  cat /sys/kernel/debug/usb/usbmon/0u > /tmp/bus &
  bus=$!
}
