#!/usr/bin/env python3
"""Checks the modules of lib/: each CMake target's USES names exactly the modules whose headers it includes, all of them
stand before it in the order of declaration, installed headers include installed headers only, and docs/architecture.md
lists the modules in that order, an inner namespace is called like its module, and apps/python links exactly the modules
that it includes. Usage: modules.py SOURCE_DIR"""

import pathlib
import re
import sys

NAMESPACE = re.compile(r"^namespace ddtool::(\w+)", re.MULTILINE)
INCLUDE = re.compile(r'^\s*#\s*include "([^"]+/[^"]+)"', re.MULTILINE)
# The layers ("floors") inside a module that is one target. A layer may only use the layers before it.
FLOORS = {"logs": ["logs/containers", "logs/messages", "logs/stream"]}


class Module:
    def __init__(self, lib, place, name, arguments):
        options = re.split(r"\b(FOLDER|SOURCES|USES)\b", arguments)
        values = dict(zip(options[1::2], options[2::2]))
        self.name = name
        self.folder = values.get("FOLDER", name).strip()
        self.uses = set(re.findall(r"ddtool::(\w+)", values.get("USES", "")))
        self.source = lib / place / "src" / self.folder
        self.public = lib / name / "include"

    def files(self, others):
        """Its own files, not those of a module whose folder lies inside its own."""
        inner = [other.source for other in others if other is not self and self.source in other.source.parents]
        for folder in (self.source, self.public):
            for path in sorted(folder.rglob("*")):
                if path.suffix in (".hpp", ".cpp", ".in") and not any(place in path.parents for place in inner):
                    yield path


def modules_in_order(lib):
    places = re.findall(r"^\s*add_subdirectory\((\w+)\)", (lib / "CMakeLists.txt").read_text(), re.MULTILINE)
    for place in places:
        text = (lib / place / "CMakeLists.txt").read_text()
        for name, arguments in re.findall(r"ddtool_module\((\w+)\s([^()]*(?:\([^()]*\)[^()]*)*)\)", text):
            yield Module(lib, place, name, arguments)


def owner(include, modules):
    """The module of a header as it is included, by the longest folder that fits; None for other libraries' headers."""
    if include.startswith("ddtool/"):
        return next((module for module in modules if include.startswith(f"ddtool/{module.name}/")), None)
    fitting = [module for module in modules if include.startswith(module.folder + "/")]
    return max(fitting, key=lambda module: len(module.folder), default=None)


def problems_of(module, earlier, modules):
    included = {}
    for path in module.files(modules):
        for include in INCLUDE.findall(path.read_text()):
            used = owner(include, modules)
            if used and used is not module:
                included.setdefault(used.name, path)
            if module.public in path.parents and not include.startswith("ddtool/"):
                yield f"{path}: is installed and includes {include}, which is not"
    for name, path in included.items():
        if name not in module.uses:
            yield f"{path}: includes {name}, which {module.name} does not declare in USES"
        if name not in earlier:
            yield f"{path}: includes {name}, which stands after {module.name}"
    for name in sorted(module.uses - set(included)):
        yield f"{module.name} declares {name} in USES and includes none of its headers"


def wrong_namespaces(module, modules):
    for path in module.files(modules):
        for name in NAMESPACE.findall(path.read_text()):
            if name != module.name:
                yield f"{path}: the namespace ddtool::{name} is not called like the module, {module.name}"


def wrong_floors(lib, name, floors):
    for index, floor in enumerate(floors):
        for path in sorted((lib / name / "src" / floor).glob("*.?pp")):
            for include in INCLUDE.findall(path.read_text()):
                if any(include.startswith(later + "/") for later in floors[index + 1 :]):
                    yield f"{path}: includes {include} of a later floor"


def wrong_links(app, modules):
    """The program or package links exactly the modules whose headers it includes."""
    linked = set(re.findall(r"ddtool::(\w+)", (app / "CMakeLists.txt").read_text()))
    included = {used.name for path in sorted(app.glob("*.?pp")) for include in INCLUDE.findall(path.read_text())
                if (used := owner(include, modules))}
    for name in sorted(linked ^ included):
        yield f"{app}: {name} is " + ("linked and none of its headers included" if name in linked else "not linked")


def main(source_dir):
    lib = source_dir / "lib"
    modules = list(modules_in_order(lib))
    problems = []
    for index, module in enumerate(modules):
        problems += problems_of(module, {other.name for other in modules[:index]}, modules)
        problems += wrong_namespaces(module, modules)
    problems += wrong_links(source_dir / "apps" / "python", modules)
    for name, floors in FLOORS.items():
        problems += wrong_floors(lib, name, floors)
    places = {path.name for path in lib.iterdir() if path.is_dir()}
    problems += [f"lib/{place}: no module of it is declared" for place in
                 places - {module.source.relative_to(lib).parts[0] for module in modules}]
    listed = re.findall(r"^\| `(\w+)` \|", (source_dir / "docs" / "architecture.md").read_text(), re.MULTILINE)
    names = [module.name for module in modules]
    if [name for name in listed if name in names] != names:
        problems.append(f"docs/architecture.md: lists {listed}, but lib/ has {names}")
    edges = sum(len(module.uses) for module in modules)
    print("\n".join(problems) or f"{len(modules)} modules, {edges} edges, each declared and used")
    return 1 if problems or not modules else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
