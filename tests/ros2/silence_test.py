#!/usr/bin/env python3
"""silence_test.py BUILD CONFIG with|without: which programs listen or send on networks. Run it in_network.

The daemon with the shipped CONFIG and the emulated robot, beside a network to other machines: an Ethernet pair (veth)
whose packets are counted. `with`: the programs have ROS 2.
"""
import contextlib
import glob
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import urllib.request

sys.path.append(os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "support"))
from verdict import check, run  # noqa: E402

LISTENING = "0A"
NEAR, FAR = "out0", "out1"


def network():
    run("ip", "link", "add", NEAR, "type", "veth", "peer", "name", FAR)
    for name in (NEAR, FAR):
        # The kernel's own packets: IPv6 looks for neighbours and routers.
        with open(f"/proc/sys/net/ipv6/conf/{name}/disable_ipv6", "w", encoding="utf-8") as file:
            file.write("1")
        run("ip", "link", "set", name, "up")
    run("ip", "address", "add", "10.0.0.1/24", "dev", NEAR)
    run("ip", "route", "add", "default", "via", "10.0.0.2")


def packets():
    """Number of packets sent to other machines."""
    with open("/proc/net/dev", encoding="utf-8") as file:
        for line in file:
            name, _, counters = line.partition(":")
            if name.strip() == NEAR:
                return int(counters.split()[9])
    sys.exit(f"failed: no {NEAR}")


def sockets():
    """Protocol, address and port of all sockets of the network that listen or need no connection."""
    found = set()
    for protocol in ("tcp", "tcp6", "udp", "udp6", "raw", "raw6", "packet"):
        with open("/proc/net/" + protocol, encoding="utf-8") as file:
            rows = [line.split() for line in file.readlines()[1:]]
        for row in rows:
            if protocol == "packet":
                found.add("packet " + row[0])
            elif not protocol.startswith("tcp") or row[3] == LISTENING:
                host, port = row[1].split(":")
                # IPv4: four bytes in the processor's order.
                host = ".".join(str(int(host[i:i + 2], 16)) for i in (6, 4, 2, 0)) if len(host) == 8 else host
                found.add(f"{protocol} {host}:{int(port, 16)}")
    return found


def open_sockets(process):
    """Open files of the process that are sockets of any kind; none if it has ended."""
    found = set()
    for path in glob.glob(f"/proc/{process.pid}/fd/*"):
        with contextlib.suppress(FileNotFoundError, PermissionError):
            found.add(os.readlink(path))
    return {target for target in found if target.startswith("socket:")}


class Watched:
    """A program, and its observed network activity until its end."""

    def __init__(self, command, status=0, meanwhile=None):
        before = packets()
        self.network, self.own, self.looks = set(), set(), 0
        with tempfile.TemporaryFile("w+") as log:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=log)
            while process.poll() is None:
                self.own |= open_sockets(process)
                self.network |= sockets()
                self.looks += 1
                if meanwhile is not None and meanwhile(self):
                    meanwhile = None
                time.sleep(0.01)
            log.seek(0)
            self.log = log.read()
        self.sent = packets() - before
        check(process.returncode == status, f"{' '.join(command)}: status {process.returncode}\n{self.log}")
        check(meanwhile is None, f"{' '.join(command)}: the page was never there\n{self.log}")
        self.said = f"{' '.join(command)}: {self.looks} looks, sent {self.sent}, own {sorted(self.own)}, network {sorted(self.network)}"
        check(self.looks > 10, self.said)

    def expect(self, network):
        """Checks that there were only these sockets, and no packets."""
        check(self.network == network and len(self.own) >= len(network) and bool(self.own) == bool(network)
              and self.sent == 0, f"{self.said}\n{self.log}")
        print(self.said)


def page(watched):
    """Reads the page once the daemon listens; returns whether it did."""
    if "tcp 127.0.0.1:8765" not in watched.network:
        return False
    with urllib.request.urlopen("http://127.0.0.1:8765/", timeout=10) as answer:
        check(b"<html" in answer.read().lower(), "no page on 127.0.0.1:8765")
    return True


def main(build, config, ros2):
    network()
    check(not sockets() and packets() == 0, f"the network is not silent: {sockets()}, {packets()} packets")
    with tempfile.TemporaryDirectory() as folder:
        port = folder + "/port"
        robot = subprocess.Popen(["setpriv", "--pdeathsig", "KILL", build + "/bin/tp100-sim", "robot", "--link", port],
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE)
        try:
            robot.stdout.readline()

            def daemon(*more, meanwhile=None, **changed):
                with open(config, encoding="utf-8") as shipped:
                    text = shipped.read()
                for key, value in changed.items():
                    text, count = re.subn(rf"(?m)^{key} = .*$", f"{key} = {value}", text)
                    check(count == 1, f"{config}: {count} lines of {key}")
                with open(folder + "/tp100.toml", "w", encoding="utf-8") as used:
                    used.write(text)
                watched = Watched([build + "/bin/tp100d", "run", "--config", folder + "/tp100.toml", "--port", port,
                                   "--course", "1-straight", "--duration", "4", *more], status=1, meanwhile=meanwhile)
                check("arming -> running" in watched.log, f"it did not drive\n{watched.log}")
                return watched

            daemon(meanwhile=page).expect({"tcp 127.0.0.1:8765"})
            daemon("--listen", "off").expect(set())
            check(not open_sockets(robot), f"the emulated robot has {open_sockets(robot)}")
            Watched([build + "/bin/tp100-sim", "course", "3", "--camera", "--runs", "3"]).expect(set())
            check(packets() == 0, f"{packets()} packets were sent")
            if ros2 == "with":
                local = daemon("--listen", "off", enabled="true")
                check(local.sent == 0 and any(each.startswith("udp ") for each in local.network), local.said)
                # Shows that the test can detect packets and sockets.
                out = daemon("--listen", "off", enabled="true", interface=f'"{NEAR}"')
                check(out.sent > 0 and out.own, out.said)
        finally:
            robot.send_signal(signal.SIGKILL)
            robot.wait()


if __name__ == "__main__":
    main(*sys.argv[1:])
