"""A small PC in QEMU: two 16550s, an FTDI adapter on USB, and no disk."""
import subprocess

from verdict import check, find

MEMORY_MB = 1024


def boot(kernel, root, log, limit_s, options=""):
    """Runs the machine until it switches itself off; returns the output of its first serial port. `options`: for the
    kernel."""
    command = [
        find("qemu-system-x86_64", "qemu-system-x86"), "-nodefaults", "-no-reboot", "-display", "none",
        "-m", str(MEMORY_MB),
        # The machine's time is the number of executed instructions, so nothing in it is late, however busy the host is.
        "-accel", "tcg,thread=single", "-icount", "shift=1,sleep=off", "-rtc", "clock=vm",
        "-kernel", kernel + "/vmlinuz", "-initrd", root,
        "-append", f"console=ttyS0 quiet loglevel=3 panic=-1 {options}",
        "-serial", "file:" + log, "-serial", "null",
        "-device", "qemu-xhci", "-chardev", "null,id=bridge", "-device", "usb-serial,chardev=bridge,always-plugged=on",
    ]
    try:
        ended = subprocess.run(command, text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, timeout=limit_s, check=False)
    except subprocess.TimeoutExpired:
        ended = None
    with open(log, encoding="utf-8", errors="replace") as file:
        output = file.read().replace("\r", "")
    check(ended is not None, f"the machine did not switch itself off within {limit_s} s; it said:\n{output}")
    check(ended.returncode == 0, f"qemu-system-x86_64: status {ended.returncode}: {ended.stdout}\n{output}")
    return output
