#!/usr/bin/env python3
"""Checks that everything that the documents name exists: tests/documents/references.py ROOT DDTOOL

These are links to files and to headings in them, files of the repository written as `folder/file`, names in them written as
`folder/file`: `name`, tests written as `Suite.Name`, and the settings filter.* of ddtool slam."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

root = pathlib.Path(sys.argv[1]).resolve()
documents = [file for file in root.rglob("*.md") if "build" not in file.relative_to(root).parts]
tests = {
    f"{suite}.{name}"
    for file in (root / "tests").rglob("*.cpp")
    for suite, name in re.findall(r"\bTEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\s*\)", file.read_text())
}
suites = {test.split(".")[0] for test in tests}
missing = []
checked = 0


def filter_settings(ddtool):
    """The settings of the filter, from the JSON output of a run."""
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "log.clf").write_text("FLASER 5 2 2.1 2.2 2.1 2 0 0 0 0 0 0 10.0 host 0\n")
        run = [ddtool, "slam", "--quiet", "--json", "--log", "log.clf", "--out", "run"]
        output = subprocess.run(run, cwd=folder, capture_output=True, text=True, check=True).stdout
    return json.loads(output)["settings"]["filter"]


def has_setting(settings, path):
    for key in path.split("."):
        if not isinstance(settings, dict) or key not in settings:
            return False
        settings = settings[key]
    return True


def anchor(heading):
    """The anchor that GitHub makes of a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors(document):
    return {anchor(heading) for heading in re.findall(r"^#+ (.*)", document.read_text(), flags=re.M)}


settings = filter_settings(sys.argv[2])


def expect(there, document, what):
    global checked
    checked += 1
    if not there:
        missing.append(f"{document.relative_to(root)}: {what} is not there")


def named_file(path):
    """Whether the file exists. `lib/filter/include/ddtool/filter/rbpf` stands for its header, and a pattern such as
    `lib/network/src/network/*` for every file that it matches."""
    return any(root.glob(path)) or any(root.glob(path + ".*"))


for document in documents:
    text = re.sub(r"^```.*?^```", "", document.read_text(), flags=re.M | re.S)
    for link, heading in re.findall(r"\]\(([^)#\s]*)(?:#([^)]*))?\)", text):
        if "://" not in link:
            target = document.parent / link if link else document
            expect(target.exists() and (not heading or heading in anchors(target)), document, f"{link}#{heading}")
    # The changelog and the reports may mention names that existed at their time.
    past = document.name == "CHANGELOG.md" or "reports" in document.parts
    for path in [] if past else re.findall(r"\bfilter((?:\.[a-z_]+)+)\b", text):
        expect(path in (".md", ".hpp", ".cpp") or has_setting(settings, path[1:]), document, f"filter{path}")
    for path in re.findall(r"`((?:lib|apps|tests|scripts|configs|data|docs)/[\w/.*-]+)`", text):
        expect(named_file(path), document, path)
    for path, name in re.findall(r"`(lib/[\w/.]+)`: `(\w+)`", text):
        expect((root / path).is_file() and re.search(rf"\b{name}\b", (root / path).read_text()), document, f"{name} in {path}")
    for test in re.findall(r"`([A-Z]\w+\.[A-Z]\w+)`", text):
        if test.split(".")[0] in suites or document.name == "paper.md":
            expect(test in tests, document, f"the test {test}")

print("\n".join(missing) or f"{checked} references in {len(documents)} documents")
sys.exit(1 if missing or checked < 100 else 0)
