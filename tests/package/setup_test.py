"""scripts/setup and scripts/campaign on a machine that says to be another: programs in a folder ahead in PATH."""
import os
import tempfile

from host import ROOT, check, run

GNU = 'echo "GNU parallel 20221122"'
MOREUTILS = "echo \"parallel: invalid option -- '-'\" >&2; exit 1"


class Machine:
    """Has every package but `parallel`, apt-get that writes down how it is called, and a sudo that drops variables."""

    def __init__(self, folder, parallel, installed=""):
        self.log = folder + "/apt"
        self.path = f"{folder}/bin:{os.environ['PATH']}"
        os.makedirs(folder + "/bin")
        for name, script in {
                "parallel": parallel,
                "dpkg-query": f'[ "$3" = parallel ] && echo "{installed}" || echo "install ok installed"',
                "apt-get": f'echo "$DEBIAN_FRONTEND $*" >> {self.log}',
                "sudo": 'exec env -i PATH="$PATH" "$@"',
                "id": "echo 1000",
                "tp100-sim": "echo 1"}.items():
            with open(f"{folder}/bin/{name}", "w", encoding="utf-8") as file:
                file.write(f"#!/bin/sh\n{script}\n")
            os.chmod(f"{folder}/bin/{name}", 0o755)
        self.folder = folder

    def run(self, *command, good=True):
        return run(*command, good=good, env=dict(os.environ, PATH=self.path, TP100_BIN=self.folder + "/bin"))

    def asked(self):
        """How apt-get was called."""
        if not os.path.exists(self.log):
            return ""
        with open(self.log, encoding="utf-8") as file:
            return file.read()


def setup(_build):
    with tempfile.TemporaryDirectory() as at:
        machine = Machine(at + "/moreutils", MOREUTILS)
        machine.run(ROOT + "/scripts/setup", "parallel")
        asked = machine.asked()
        check(asked.startswith("noninteractive install ") and asked.endswith(" parallel\n"),
              f"beside moreutils' parallel, and by sudo, apt-get was asked '{asked}'")

        machine = Machine(at + "/gnu", GNU)
        machine.run(ROOT + "/scripts/setup", "parallel")
        check(not machine.asked(), f"GNU parallel is there, but apt-get was asked '{machine.asked()}'")

        machine = Machine(at + "/hidden", MOREUTILS, "install ok installed")
        os.mkdir(at + "/out")
        said = machine.run(ROOT + "/scripts/campaign", ROOT + "/config/campaigns/course-3.toml", "--out", at + "/out",
                           good=False)
        check("is not GNU parallel; " in said, f"scripts/campaign with moreutils' parallel said '{said}'")
