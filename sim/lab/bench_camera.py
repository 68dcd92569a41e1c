"""Finds the marker in rendered images of an overhead camera on courses 1-3, with steady light, moving light and a hand; takes
half an hour. Usage: sim/lab/bench_camera.py FOLDER_OF_PROGRAMS"""
import json
import os
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.append(os.path.join(os.path.dirname(os.path.realpath(__file__)), "../../tests/bench"))
from bench_table import ROOT, Table

DRIVES = [(course, "flat") for course in ("1-straight", "1-curve", "1-sharp", "2", "3")] + [("3", "terrain")]
CONDITIONS = (("steady", [], DRIVES), ("moving", ["--light", "moving"], DRIVES),
              ("hand", ["--light", "moving", "--hand"], DRIVES[1:5:2] + DRIVES[5:]),
              ("calibrated", ["--calibrate"], DRIVES[:1]))
RATE_HZ = 2


def main():
    table = Table("camera", "marker in rendered images, and the fused pose that comes of it [mm]", [
        ("course", "course", "<10s"), ("setup", "set-up", "<7s"), ("light", "light", "<10s"), ("visible", "images", "5d"),
        ("covered", "covered", "5d"), ("found", "found %", "7.1f"), ("rms", "rms", "5.2f"), ("most", "max", "5.2f"),
        ("fused", "fused", "5.1f"), ("disturbed", "disturbed", "5.1f"), ("jump", "jump", "5.2f"), ("rejected", "rejected", "3d"),
        ("rate", "images/s", "5.1f"), ("verdict", "", "<6s")])
    for name, words, drives in CONDITIONS:
        for course, setup in drives:
            done = subprocess.run([os.path.join(ROOT, "sim/lab/overhead"), "--bin", sys.argv[1], "--course", course, "--setup",
                                   setup, "--rate", str(RATE_HZ), "--json", *words], stdout=subprocess.PIPE, text=True)
            if done.returncode not in (0, 1):
                sys.exit(done.returncode)
            got = json.loads(done.stdout)
            table.row(course=course, setup=setup, light=name, visible=got["visible"], covered=got["covered"],
                      found=100 * got["found_share"], rms=1e3 * got["image_rms_m"], most=1e3 * got["image_max_m"],
                      fused=1e3 * got["fused_max_m"], disturbed=1e3 * got["disturbed_max_m"], jump=1e3 * got["jump_max_m"],
                      rejected=got["rejected"], rate=got["images_per_s"],
                      verdict="broken" if done.returncode else "holds")
    table.save()


if __name__ == "__main__":
    main()
