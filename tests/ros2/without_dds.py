#!/usr/bin/env python3
"""without_dds.py BUILD: builds the programs without Cyclone DDS, which BUILD has; tests what works and what is refused."""
import glob
import json
import os
import sys
import tempfile

sys.path.append(os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "package"))
from host import ROOT, check, run  # noqa: E402
from verdict import run as attempt  # noqa: E402

# At the same depth as the presets' folders, so that the compiler's cache can reuse their objects.
WITHOUT = ROOT + "/build/without_dds"


def cache_settings():
    """The environment of the presets."""
    with open(ROOT + "/CMakePresets.json", encoding="utf-8") as file:
        base = json.load(file)["configurePresets"][0]["environment"]
    return dict(os.environ, **{name: value.replace("${sourceDir}", ROOT) for name, value in base.items()})


def build_anew():
    run("cmake", "--preset", "dev", "-B", WITHOUT, *(f"-DTP100_BUILD_{part}=OFF" for part in ("ROS2", "CAMERA", "TESTS")),
        cwd=ROOT)
    run("cmake", "--build", WITHOUT, "--target", "tp100d", "tp100-sim", env=cache_settings())
    for program in ("tp100d", "tp100-sim"):
        loaded = run("ldd", f"{WITHOUT}/bin/{program}")
        check("libzstd" in loaded and "dds" not in loaded, f"{program} loads {loaded}")


def topics_are_refused(folder):
    with open(folder + "/ros2.toml", "w", encoding="utf-8") as file:
        file.write("[ros2]\nenabled = true\n")
    for program, *words in (("tp100d", "run", "--config", folder + "/ros2.toml", "--port", folder + "/port"),
                            ("tp100-sim", "course", "3", "--ros2"),
                            ("tp100-sim", "robot", "--link", folder + "/port", "--ros2")):
        status, said = attempt(f"{WITHOUT}/bin/{program}", *words, good=False)
        check(status == 2 and len(said.splitlines()) == 1 and "built without Cyclone DDS; scripts/build installs" in said,
              f"{program} {' '.join(words)}: status {status}: {said}")


def bags_are_the_same(build, folder):
    run(build + "/bin/tp100-sim", "course", "3", "--record", folder + "/runs")
    recording = glob.glob(folder + "/runs/*")[0]
    bags = []
    for name, programs in (("with", build), ("without", WITHOUT)):
        run(programs + "/bin/tp100d", "export", recording, "--ros2", f"{folder}/{name}/bag")
        bag = {}
        for path in glob.glob(f"{folder}/{name}/bag/*"):
            with open(path, "rb") as file:
                bag[os.path.basename(path)] = file.read()
        bags.append(bag)
    check(sorted(bags[0]) == ["bag_0.mcap", "metadata.yaml"] and bags[0] == bags[1], "the bags differ")
    print(f"bags of {len(bags[0]['bag_0.mcap'])} bytes are the same")


def main(build):
    build_anew()
    with tempfile.TemporaryDirectory() as folder:
        topics_are_refused(folder)
        bags_are_the_same(build, folder)


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]))
