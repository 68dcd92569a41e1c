# Runs under systemd as root, with the package's unit and udev rules unchanged, in a machine that has booted without a
# board.
export PATH=/bin HOME=/tmp
unit=tp100d@tp100
ip link set lo up
. /guest/checks.sh
. /guest/board.sh
. /guest/daemon.sh
. /guest/service_checks.sh

cp /tmp/short.toml /etc/tp100
printf 'course = "/etc/tp100/short.toml"\n[link]\nport = "/dev/tp100-TP100A"\n' > /etc/tp100/tp100.toml
# The port belongs to the group dialout, but it is of a kind that the unit does not allow.
printf '[link]\nport = "/dev/ttyS1"\n[server]\nlisten = "off"\n' > /etc/tp100/other.toml

try starts_without_a_board
try finds_the_board_plugged_in_later
try has_its_rights
try is_kept_from_other_ports
try board_is_prepared
try bridge_is_left_alone
try bridge_is_prepared_when_asked
try starts_nothing_by_itself
try drives_as_the_service

echo "guest: done"
