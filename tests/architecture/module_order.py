#!/usr/bin/env python3
"""Checks that a module of lib/ includes only itself and modules listed before it in lib/CMakeLists.txt, and that
docs/architecture.md lists the modules in that order. Usage: module_order.py SOURCE_DIR"""

import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"/]+)/', re.MULTILINE)


def modules_in_order(lib):
    return re.findall(r"^\s*add_subdirectory\((\w+)\)", (lib / "CMakeLists.txt").read_text(), re.MULTILINE)


def wrong_includes(lib, modules):
    for index, module in enumerate(modules):
        allowed = set(modules[: index + 1])
        for path in sorted((lib / module).rglob("*.[ch]pp")):
            for used in INCLUDE.findall(path.read_text()):
                if used not in allowed:
                    yield f"{path}: includes {used}, which {module} may not use"


def wrong_documentation(document, modules):
    listed = [name for name in re.findall(r"^\| `(\w+)` \|", document.read_text(), re.MULTILINE)]
    if [name for name in listed if name in modules] != modules:
        yield f"{document}: lists {listed}, but lib/CMakeLists.txt has {modules}"


def main(source_dir):
    lib = source_dir / "lib"
    modules = modules_in_order(lib)
    folders = {path.name for path in lib.iterdir() if path.is_dir()}
    problems = [f"lib/{name}: not in lib/CMakeLists.txt" for name in sorted(folders - set(modules))]
    problems += wrong_includes(lib, modules)
    problems += wrong_documentation(source_dir / "docs" / "architecture.md", modules)
    print("\n".join(problems) or f"{len(modules)} modules in order")
    return 1 if problems or not modules else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
