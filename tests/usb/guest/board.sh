# Boards on USB: an Arduino Mega 2560 each, by the kernel's own gadget, with an emulated robot behind it.
gadgets=/sys/kernel/config/usb_gadget

# make_board N SERIAL: not plugged in yet.
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

# plug N [NUMBER]: as /dev/ttyACMNUMBER, or whichever number is free.
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

# Links as udev makes them.
name_ports() {
  rm -rf /dev/serial
  mkdir -p /dev/serial/by-id
  for tty in /sys/class/tty/ttyACM*; do
    [ -e $tty ] || continue
    ln -s ../../${tty##*/} /dev/serial/by-id/usb-Arduino-$(cat $tty/device/../serial)-if00
  done
}

# make_robot N: behind board N, which gives it power: once that is plugged in, its wire is opened, which resets it.
# While there is a file /tmp/cutN, it is not wired to the board.
make_robot() {
  tp100-sim robot --link /tmp/robot$1 > /tmp/robot$1.log 2>&1 &
  while :; do
    if [ "$(cat /sys/class/udc/dummy_udc.$1/state)" = configured ] && [ ! -e /tmp/cut$1 ]; then
      socat /dev/ttyGS$1,raw,echo=0 /tmp/robot$1,raw,echo=0
    fi
    sleep 0.05
  done 2> /dev/null &
}
# How often robot N switched its motors off for REASON.
motors_off() { grep -c "motors off: $2" /tmp/robot$1.log; }
