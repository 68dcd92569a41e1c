#!/usr/bin/env python3
"""links_test.py ROOT: every link, with the heading that it names, and every path in a page must exist, and every page must
be reachable from README.md. Links into the laboratory, sim/lab, count only where it is: the project does without it."""
import pathlib
import re
import sys

LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
# A path with a folder, in a code span, that names a file of the project.
PATH = re.compile(r"`((?:\.\./|[\w.-]+/)+[\w.-]+\.(?:h|cpp|md|toml|py|ts|js|ino|rules))`")
BLOCK = re.compile(r"^```.*?^```$", re.M | re.S)
HEADING = re.compile(r"^#+ (.*)$", re.M)
FOLDERS = ("daemon", "firmware", "sim", "config", "tests", "scripts", ".github")


def pages(root):
    found = list(root.glob("*.md"))
    for folder in FOLDERS:
        found += [one for one in (root / folder).rglob("*.md") if "node_modules" not in one.parts]
    return sorted(found)


def anchors(page):
    """The headings of a page, as links name them."""
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")
            for heading in HEADING.findall(BLOCK.sub("", page.read_text(encoding="utf-8")))}


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    lab = root / "sim/lab"
    missing = (lambda path: False) if lab.exists() else (lambda path: path == lab or lab in path.parents)
    all_pages, failures, leads_to = pages(root), [], {}
    checked = 0
    for page in all_pages:
        text = BLOCK.sub("", page.read_text(encoding="utf-8"))
        targets = leads_to.setdefault(page, set())
        for link in LINK.findall(text):
            if re.match(r"\w+:", link):
                continue
            checked += 1
            path, _, heading = link.partition("#")
            target = (page.parent / path).resolve() if path else page
            targets.add(target)
            there = target.exists() and (not heading or heading in anchors(target))
            if not there and not missing(target):
                failures.append(f"{page.relative_to(root)}: no {link}")
        for path in PATH.findall(text):
            checked += 1
            if not any((base / path).exists() or missing((base / path).resolve()) for base in (page.parent, root)):
                failures.append(f"{page.relative_to(root)}: no {path}")
    reached, left = set(), [root / "README.md"]
    while left:
        page = left.pop()
        if page not in reached:
            reached.add(page)
            left += leads_to.get(page, ())
    for page in all_pages:
        if page not in reached:
            failures.append(f"{page.relative_to(root)}: README.md does not lead to it")
    print("\n".join(failures) if failures else f"{len(all_pages)} pages, {checked} links and paths")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
