"""The package itself: its errors, its messages, and whether its stub and its docstrings say what the module has."""

import ast
import inspect
import logging
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import ddtool
from support import InFolder

STUB = ast.parse((pathlib.Path(ddtool.__file__).parent / "__init__.pyi").read_text())
SILENT = {"__repr__", "__getstate__", "__setstate__", "__new__", "__module__", "__doc__"}


class Errors(InFolder):
    def test_kinds(self):
        self.assertTrue(issubclass(ddtool.UsageError, (ddtool.Error, ValueError)))
        self.assertTrue(issubclass(ddtool.OutputError, OSError) and issubclass(ddtool.OutputError, ddtool.Error))
        with self.assertRaises(FileNotFoundError) as raised:
            ddtool.open_log(self.folder / "nothing.mcap")
        self.assertEqual(raised.exception.filename, str(self.folder / "nothing.mcap"))
        text = self.folder / "text.bag"
        text.write_text("hello")
        with self.assertRaisesRegex(ddtool.Error, "^[^\n]*text.bag[^\n]*expected MCAP[^\n]*$"):
            ddtool.open_log(text)
        with self.assertRaises(ddtool.Error):
            ddtool.read_map(text)
        with self.assertRaises(ddtool.OutputError):
            self.simulation.truth().write(self.folder / "no folder" / "a.tum")
        with self.assertRaises(OSError):
            self.simulation.write("/proc/nothing.mcap")

    def test_wrong_arguments(self):
        for error, text, arguments in (
                (ddtool.UsageError, "anti-degeneracy", {"method": "best"}),
                (ddtool.UsageError, "covariance", {"detector": "nobody"}),
                (ddtool.UsageError, "did you mean: filter.seed", {"settings": {"filter.sed": 1}}),
                (ddtool.UsageError, "filter.particles", {"particles": 0}),
                (ddtool.UsageError, "filter.grid.cell_size_m", {"settings": {"filter": {"grid": {"cell_size_m": "a"}}}}),
                (ddtool.UsageError, "back_end", {"settings": {"back_end": "graph"}}),
                (TypeError, "str as key", {"settings": {1: 2}}),
                (TypeError, "settings: expected numbers", {"settings": {"filter.seed": object()}}),
                (TypeError, "", {"settings": 3}), (TypeError, "", {"particles": "many"}),
                (TypeError, "name or a callable", {"detector": 3}), (TypeError, "", {"seed": -1}),
                (ddtool.UsageError, "threads", {"threads": 1025}),
                (ddtool.UsageError, "filter.seed", {"settings": {"filter.seed": 2**64}}),
                (ddtool.UsageError, "filter.seed", {"settings": {"filter.seed": -(2**70)}}),
                (FileNotFoundError, "no.safetensors", {"detector": "no.safetensors"})):
            with self.subTest(**{key: repr(value) for key, value in arguments.items()}):
                with self.assertRaisesRegex(error, text):
                    ddtool.Slam(**arguments)
        slam = self.new_slam()
        for call in (slam.trajectory, slam.map, lambda: slam.pose, lambda: slam.covariance):
            with self.assertRaisesRegex(ddtool.Error, "no scan yet"):
                call()
        with self.assertRaisesRegex(TypeError, "iterable of ddtool.Scan"):
            slam.run([1, 2])
        with self.assertRaises(TypeError):
            slam.update(None)
        with self.assertRaisesRegex(ValueError, "initial_pose"):
            ddtool.localize(self.folder, (1, 2))

    def test_a_map_that_grows_too_large_ends_the_run_and_keeps_it(self):
        slam = self.new_slam(settings={"filter.grid.most_memory_mib": 64})
        with self.assertRaises(ddtool.Error):
            slam.run(self.far_scan(step) for step in range(200))
        self.assertGreater(len(slam.trajectory()), 0)
        self.assertGreater(slam.map().occupancy.size, 0)
        with self.assertRaisesRegex(ddtool.Error, "cannot go on"):
            slam.update(self.far_scan(201))

    @staticmethod
    def far_scan(step):
        return ddtool.Scan([30.0] * 360, angle_min_rad=0.0, angle_increment_rad=0.01745, range_max_m=40.0,
                           stamp_ns=step, odom_from_robot=(10.0 * step, 0, 0))

    def test_seeds_are_whole_numbers_of_64_bits(self):
        import numpy as np
        for seed in (2**64 - 1, np.int64(7)):
            self.assertEqual(ddtool.Slam(settings={"filter": {"seed": seed}}, threads=1).settings["filter"]["seed"], seed)


class Messages(InFolder):
    def test_nothing_is_printed_and_messages_go_to_logging(self):
        script = ("import logging, sys, ddtool\n"
                  "logging.basicConfig(stream=sys.stderr, format='%(name)s|%(levelname)s|%(message)s')\n"
                  "slam = ddtool.Slam(seed=1, particles=4)\n"
                  "slam.run(ddtool.open_log(sys.argv[1], settings={'log.odometry': 'none'}))\n")
        done = subprocess.run([sys.executable, "-c", script, self.log], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, "")
        for line in done.stderr.splitlines():
            self.assertRegex(line, r"^ddtool\|WARNING\|")
        quiet = script.replace("slam =", "logging.getLogger('ddtool').setLevel('ERROR')\nslam =")
        done = subprocess.run([sys.executable, "-c", quiet, self.log], capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")

    def test_a_handler_that_fails_tears_nothing(self):
        class Failing(logging.Handler):
            def emit(self, record):
                raise RuntimeError("full")

        damaged = self.folder / "damaged.mcap"
        damaged.write_bytes(self.log.read_bytes()[:-20000])
        handler, hook = Failing(), sys.unraisablehook
        logging.getLogger("ddtool").addHandler(handler)
        seen = []
        sys.unraisablehook = lambda raised: seen.append(raised.exc_value)
        try:
            self.assertGreater(len(list(ddtool.open_log(damaged))), 0)
        finally:
            sys.unraisablehook = hook
            logging.getLogger("ddtool").removeHandler(handler)
        self.assertTrue(seen and all(isinstance(error, RuntimeError) for error in seen))


def public_names(thing):
    return {name for name in vars(thing) if not name.startswith("_")}


def parameters_of_stub(function):
    """(name, whether it has a default, whether it is keyword-only) of each parameter but self."""
    arguments = function.args
    plain = arguments.posonlyargs + arguments.args
    required = len(plain) - len(arguments.defaults)
    found = [(argument.arg, place >= required, False) for place, argument in enumerate(plain)]
    found += [(argument.arg, default is not None, True)
              for argument, default in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    return [each for each in found if each[0] != "self"]


def parameters_of_docstring(doc):
    """The same from the first line of a docstring of pybind11: name(self: T, a: T, *, b: T = 1) -> T."""
    inside = doc.splitlines()[0].partition("(")[2].rpartition(") ->")[0]
    parts, depth, part = [], 0, ""
    for letter in inside:
        depth += {"[": 1, "(": 1, "{": 1, "]": -1, ")": -1, "}": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            parts.append(part)
            part = ""
        else:
            part += letter
    found, only_by_name = [], False
    for each in [*parts, part]:
        name = each.partition(":")[0].strip()
        if name == "*":
            only_by_name = True
        elif name and name != "self" and not re.fullmatch(r"arg\d", name):
            found.append((name, "=" in each, only_by_name))
    return found


class Stub(unittest.TestCase):
    nodes = {node.name: node for node in STUB.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}

    def test_has_every_name_and_no_other(self):
        module = {name for name in public_names(ddtool) if not inspect.ismodule(getattr(ddtool, name))}
        self.assertEqual(module, set(self.nodes))

    def test_functions_have_their_parameters(self):
        for name, node in self.nodes.items():
            if isinstance(node, ast.FunctionDef):
                with self.subTest(name):
                    self.assertEqual(parameters_of_stub(node), parameters_of_docstring(getattr(ddtool, name).__doc__))

    def test_classes_have_their_members(self):
        for name, node in self.nodes.items():
            if not isinstance(node, ast.ClassDef) or issubclass(getattr(ddtool, name), Exception):
                continue
            members = {each.name: each for each in node.body if isinstance(each, ast.FunctionDef)}
            kind = getattr(ddtool, name)
            own = {each for each in vars(kind) if each not in SILENT and not each.startswith("__pybind")
                   and not each.startswith("_pybind")}
            if "__init__" in own and kind.__init__.__doc__.endswith("signature") or "__init__" not in members:
                own.discard("__init__")
            with self.subTest(name):
                self.assertEqual(own, set(members))
            for member, stub in members.items():
                found = inspect.getattr_static(kind, member)
                with self.subTest(f"{name}.{member}"):
                    is_property = any(getattr(each, "id", "") == "property" for each in stub.decorator_list)
                    self.assertEqual(is_property, isinstance(found, property))
                    if not is_property and not (member.startswith("__") and member != "__init__"):
                        self.assertEqual(parameters_of_stub(stub), parameters_of_docstring(getattr(kind, member).__doc__))

    def test_every_name_is_explained(self):
        for name, node in self.nodes.items():
            kind = getattr(ddtool, name)
            self.assertTrue(kind.__doc__, name)
            for member in public_names(kind) if isinstance(kind, type) else ():
                thing = inspect.getattr_static(kind, member)
                doc = thing.__doc__ if isinstance(thing, property) else getattr(kind, member).__doc__
                self.assertGreater(len(doc.partition("->")[2] or doc), 8, f"{name}.{member}")
        self.assertEqual(ddtool.Slam.__module__, "ddtool")
        self.assertRegex(ddtool.__version__, r"^\d+\.\d+\.\d+$")

    @unittest.skipUnless(os.path.exists("/usr/bin/mypy"), "mypy is not installed")
    def test_the_examples_fit_it(self):
        examples = pathlib.Path(os.environ["EXAMPLES"])
        with tempfile.NamedTemporaryFile("w", suffix=".ini") as config:
            config.write("[mypy]\nstrict = True\n[mypy-torch.*]\nfollow_imports = skip\n")  # torch takes minutes
            config.flush()
            checked = subprocess.run(["/usr/bin/mypy", "--config-file", config.name, "--cache-dir", "/dev/null",
                                      *sorted(map(str, examples.glob("*.py")))], capture_output=True, text=True)
        self.assertEqual(checked.returncode, 0, checked.stdout)


if __name__ == "__main__":
    unittest.main()
