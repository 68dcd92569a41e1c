"""Downloads Debian's packages for the small machine into a folder, without installing them."""
import os

from verdict import find, run, skip


def download(packages, folder):
    """Paths of the packages in `folder`."""
    # Otherwise apt warns that its own user cannot write there.
    status, output = run(find("apt-get", "apt"), "-q", "-o", "APT::Sandbox::User=", "download", *packages, good=False,
                         cwd=folder)
    debs = [os.path.join(folder, name) for name in sorted(os.listdir(folder)) if name.endswith(".deb")]
    if status != 0 or len(debs) != len(packages):
        skip(f"apt-get download {' '.join(packages)}: {' '.join(output.splitlines()[-1:])}; run apt-get update")
    return debs
