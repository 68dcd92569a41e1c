"""The overhead camera of sim/lab/overhead: its mounting, files and settings, and the engine that renders its images."""
import contextlib
import math
import os
import re
import signal
import socket
import subprocess
import sys
import time

from engine_runs import PATIENCE_S, ROOT, engine_environment, fail

# The camera: a sensor of 800x500, 2.5 m above the floor, slightly off-centre and tilted towards the fence's middle.
LENS = {"width_px": 800, "height_px": 500, "cx_px": 396.0, "cy_px": 253.5, "k1": -0.09, "k2": 0.02}
HEIGHT_M, ASIDE_M, TURNED_DEG = 2.5, (0.07, -0.05), 3.0
# Rows are exposed for 8 ms, the last one 4 ms after the first: subframes every 2 ms, 4 in a row's mean.
SPACING_S, IN_EXPOSURE, LAST_ROW_BEGINS = 0.002, 4, 2
NOISE = 0.012  # standard deviation, as a share of white
MARKER_M, MARKER_HEIGHT_M, FLOOR_MARKER_M, FLOOR_MARKER_OUT_M = 0.10, 0.08, 0.12, 0.12
BOARD, BOARD_M = "charuco:7x5:0.04:0.03", (0.32, 0.24)
SHEET_PX = 1024


def box(fence):
    """Bounds of a fence: least x, largest x, least y, largest y."""
    corners = fence.get("corners_m") or [(fence["min_x_m"], fence["min_y_m"]), (fence["max_x_m"], fence["max_y_m"])]
    x, y = zip(*corners)
    return min(x), max(x), min(y), max(y)


def undistorted(radius):
    """Undistorted length of the ray with this distorted length."""
    r = radius
    for _ in range(20):
        r = radius / (1 + LENS["k1"] * r * r + LENS["k2"] * r ** 4)
    return r


class Camera:
    """The camera over a fence: its files for tp100-camera and the daemon, and its settings for the engine."""

    def __init__(self, fence, folder):
        self.folder = folder
        left, right, low, high = box(fence)
        self.middle = ((left + right) / 2, (low + high) / 2)
        self.place = (self.middle[0] + ASIDE_M[0], self.middle[1] + ASIDE_M[1])
        self.corners = [(x, y) for x in (left - FLOOR_MARKER_OUT_M, right + FLOOR_MARKER_OUT_M)
                        for y in (low - FLOOR_MARKER_OUT_M, high + FLOOR_MARKER_OUT_M)]
        seen = [right - left + 2 * FLOOR_MARKER_OUT_M + 1.7 * FLOOR_MARKER_M,
                high - low + 2 * FLOOR_MARKER_OUT_M + 1.7 * FLOOR_MARKER_M]
        focal = 0.9 * HEIGHT_M * min(LENS["width_px"] / seen[0], LENS["height_px"] / seen[1])
        self.lens = LENS | {"focal_px": round(focal, 1)}

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="ascii") as file:
            file.write(text)
        return self.path(name)

    def files(self, **more):
        """view.toml and lens.toml for tp100-camera, tp100.toml for the daemon, with more keys of [camera]."""
        lens = self.lens
        self.write("lens.toml", "".join(f"{key} = {value}\n" for key, value in {
            "width_px": lens["width_px"], "height_px": lens["height_px"], "fx_px": lens["focal_px"],
            "fy_px": lens["focal_px"], "cx_px": lens["cx_px"], "cy_px": lens["cy_px"], "k1": lens["k1"],
            "k2": lens["k2"]}.items()))
        self.write("view.toml", f'lens = "lens.toml"\n[marker]\nsize_m = {MARKER_M}\nheight_m = {MARKER_HEIGHT_M}\n' +
                   "".join(f"[[floor_marker]]\nid = {10 + i}\nx_m = {x}\ny_m = {y}\n" for i, (x, y) in enumerate(self.corners)))
        self.write("tp100.toml", f"[camera]\nheight_m = {HEIGHT_M}\noffset_x_m = {ASIDE_M[0]}\noffset_y_m = {ASIDE_M[1]}\n"
                   f"marker_height_m = {MARKER_HEIGHT_M}\n" + "".join(f"{key} = {value}\n" for key, value in more.items()))

    def sheet(self, camera_program, number, size_m):
        """A printed marker: its drawing, and the side of the sheet."""
        view = self.write(f"print-{number}.toml", self.read("view.toml").replace(f"size_m = {MARKER_M}", f"size_m = {size_m}"))
        file = self.path(f"marker-{number}.svg")
        subprocess.run([camera_program, "--print-marker", file, "--id", str(number), "--view", view], check=True)
        os.remove(view)
        drawing = self.read(file)
        side = re.search(r'width="([\d.]+)mm"', drawing)
        # A power of two: the engine halves the size repeatedly, which would cut pixels off other sizes.
        self.write(os.path.basename(file), re.sub(r'(width|height)="[\d.]+mm"', rf'\1="{SHEET_PX}"', drawing))
        return {"file": file, "side_m": float(side[1]) / 1000, "size_m": size_m}

    def read(self, name):
        with open(self.path(name), encoding="ascii") as file:
            return file.read()

    def settings(self, camera_program):
        """The engine's settings except those of the drive."""
        lens = self.lens
        widest = [max(abs(edge - centre) for edge in (0, size)) / lens["focal_px"] for size, centre in
                  ((lens["width_px"], lens["cx_px"]), (lens["height_px"], lens["cy_px"]))]
        wider = undistorted(math.hypot(*widest)) / math.hypot(*widest)
        return {
            "lens": lens, "noise": NOISE, "subframe_spacing_s": SPACING_S, "in_exposure": IN_EXPOSURE,
            "last_row_begins": LAST_ROW_BEGINS,
            # Slightly larger than the lens's field of view, at the same scale.
            "pinhole": {"focal_px": lens["focal_px"], "width_px": 2 * math.ceil(widest[0] * wider * lens["focal_px"] + 2),
                        "height_px": 2 * math.ceil(widest[1] * wider * lens["focal_px"] + 2)},
            "place": {"x_m": self.place[0], "y_m": self.place[1], "height_m": HEIGHT_M, "middle_x_m": self.middle[0],
                      "middle_y_m": self.middle[1], "turned_deg": TURNED_DEG},
            "marker": self.sheet(camera_program, 0, MARKER_M) | {"height_m": MARKER_HEIGHT_M},
            "floor_markers": [self.sheet(camera_program, 10 + i, FLOOR_MARKER_M) | {"x_m": x, "y_m": y, "turned_deg": 40 * i}
                              for i, (x, y) in enumerate(self.corners)]}


def engine():
    """The command that starts off-screen rendering. The engine's time is the drive's."""
    return ["xvfb-run", "-a", "-s", "-screen 0 64x64x24", "godot3-runner", "--video-driver", "GLES2", "--audio-driver",
            "Dummy", "--resolution", "64x64", "--fixed-fps", "500", "--path", os.path.join(ROOT, "sim/godot"),
            os.path.join(ROOT, "sim/lab/godot/overhead.tscn")]


@contextlib.contextmanager
def rendering(settings):
    """The engine and the socket that delivers its images; the engine ends with the context at the latest."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        settings |= {"port": server.getsockname()[1]}
        world = subprocess.Popen(engine(), env=engine_environment("TP100_OVERHEAD", settings), stdout=subprocess.DEVNULL,
                                 start_new_session=True)
        try:
            server.settimeout(1)
            until_s = time.monotonic() + PATIENCE_S
            while True:
                try:
                    connection, _ = server.accept()
                    break
                except TimeoutError:
                    # With a time limit: if the engine cannot read its scripts, it keeps running without them.
                    if world.poll() is not None or time.monotonic() > until_s:
                        fail("the engine did not come up; its messages are above")
            connection.settimeout(None)
            with connection:
                yield world, connection
        finally:
            if world.poll() is None:
                os.killpg(world.pid, signal.SIGTERM)
                world.wait()


def render(settings, reader):
    """Renders images into the standard input of the command `reader`; returns the seconds that it took."""
    began = time.monotonic()
    with rendering(settings) as (world, connection):
        finder = subprocess.Popen(reader, stdin=connection.fileno(), stdout=sys.stderr)
        connection.close()
        if finder.wait() not in (0, 1) or world.wait(30):
            fail("no images; the messages of the engine and of tp100-camera are above")
    return time.monotonic() - began
