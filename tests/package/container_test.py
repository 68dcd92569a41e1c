"""Builds the container from the package, and runs it as a user would: without arguments, and with a robot's port."""
import contextlib
import glob
import json
import os
import re
import select
import shutil
import subprocess
import tempfile
import time
import urllib.error
import urllib.request

from host import ROOT, check, need, package, run, skip

LARGEST_MB = 150


def may_build():
    need(("buildah", "buildah"), ("mmdebstrap", "mmdebstrap"), ("dpkg-scanpackages", "dpkg-dev"))
    if os.geteuid() != 0 and subprocess.run(["buildah", "unshare", "true"], stdout=subprocess.DEVNULL,
                                            stderr=subprocess.DEVNULL, check=False).returncode != 0:
        skip("no user namespaces for this user (/etc/subuid, user.max_user_namespaces)")
    try:
        urllib.request.urlopen("http://deb.debian.org/debian/dists/bookworm/InRelease", timeout=20).close()
    except (urllib.error.URLError, OSError) as error:
        skip(f"Debian's archive cannot be reached: {error}")


class Output:
    """The output of a program, line by line."""

    def __init__(self, *command, env):
        self.text = ""
        # Its input stays open, without Enter.
        self.program = subprocess.Popen(command, env=env, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.STDOUT, start_new_session=True)

    def until(self, pattern, limit_s=90):
        end = time.monotonic() + limit_s
        while not (found := re.search(pattern, self.text)):
            ready = select.select([self.program.stdout], [], [], max(0, end - time.monotonic()))[0]
            got = os.read(self.program.stdout.fileno(), 65536) if ready else b""
            check(got, f"no '{pattern}' in:\n{self.text}")
            self.text += got.decode(errors="replace")
        return found

    def close(self):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self.program.pid, 15)
        self.program.communicate(timeout=60)


def drives_the_emulated_robot(container, env):
    """The entry point, as `docker run` starts it: the robot drives, and the page is there."""
    run_it = Output("buildah", "run", "--env", "TP100_LISTEN=127.0.0.1:0", container, "/usr/bin/tp100-start", env=env)
    try:
        page = run_it.until(r"page: (http://127\.0\.0\.1:\d+/)")[1]
        with urllib.request.urlopen(page, timeout=20) as answer:
            check(b"<!doctype html>" in answer.read(), f"{page} is no page")
        run_it.until("hello from an emulated board")
        # Does not wait for the end: a pause of the machine of 200 ms ends any drive in real time.
        run_it.until("motors on")
    finally:
        run_it.close()


def treats_a_port_as_physical(container, env, robot, folder):
    """With a port whose board identifies itself as a Mega, nothing may start by itself."""
    link = folder + "/robot"
    robot = Output(robot, "robot", "--board", "avr", "--link", link, env=env)
    try:
        robot.until("linked from")
        os.chmod(os.path.realpath(link), 0o666)
        run_it = Output("buildah", "run", "--volume", os.path.realpath(link) + ":/srv/robot", container, "tp100d", "run",
                        "--port", "/srv/robot", "--course", "1-straight", "--listen", "127.0.0.1:0", env=env)
        try:
            run_it.until("hello from a Mega 2560")
            run_it.until("press Enter to start")
            check("arming" not in run_it.text, f"it started by itself:\n{run_it.text}")
        finally:
            run_it.close()
    finally:
        robot.close()


def container(build, robot=None):
    """The container of this build's package; its robot's port is that of the program `robot`, the build's without one."""
    may_build()
    folder = tempfile.mkdtemp(prefix="tp100-container-")
    os.chmod(folder, 0o755)
    env = dict(os.environ, CONTAINERS_STORAGE_CONF=folder + "/storage.conf", BUILDAH_ISOLATION="chroot")
    try:
        print(run(ROOT + "/scripts/container", "--deb", package(build), "--out", folder))
        archive = glob.glob(folder + "/tp100_*.tar")[0]
        size_mb = os.path.getsize(archive) / 1e6
        check(size_mb <= LARGEST_MB, f"the image has {size_mb:.0f} MB, at most {LARGEST_MB} were promised")
        with open(folder + "/storage.conf", "w", encoding="utf-8") as file:
            file.write(f'[storage]\ndriver = "vfs"\ngraphroot = "{folder}/storage"\nrunroot = "{folder}/run"\n')
        run("buildah", "pull", "docker-archive:" + archive, env=env)
        image = json.loads(run("buildah", "images", "--json", env=env))[0]["id"]
        settings = json.loads(run("buildah", "inspect", "--type", "image", image, env=env))["OCIv1"]["config"]
        check(settings["User"] == "tp100" and settings["Entrypoint"] == ["/usr/bin/tp100-start"]
              and "8765" in str(settings["ExposedPorts"]), f"the image's settings: {settings}")
        # The last line: a warning about an image for another processor may come first.
        made = run("buildah", "from", image, env=env).splitlines()[-1]
        drives_the_emulated_robot(made, env)
        treats_a_port_as_physical(made, env, robot or build + "/bin/tp100-sim", folder)
        print("built, driven, and a robot's port waited for Enter")
    finally:
        # Files that belong to another user of the namespace can be removed only inside it.
        if os.geteuid() != 0:
            subprocess.run(["buildah", "unshare", "rm", "-rf", folder], check=False)
        shutil.rmtree(folder, ignore_errors=True)
