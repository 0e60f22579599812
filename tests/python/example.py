"""Runs an example and looks at the figure that it prints last: example.py EXAMPLE [LOG], where LOG stands for a log of a
small corridor."""

import re
import subprocess
import sys

from support import InFolder

InFolder.setUpClass()
try:
    arguments = [str(InFolder.log) if each == "LOG" else each for each in sys.argv[1:]]
    printed = subprocess.run([sys.executable, *arguments], check=True, capture_output=True, text=True).stdout
finally:
    InFolder.tearDownClass()
print(printed)
degree, error_m = (re.search(pattern, printed) for pattern in (r"mean degree (\S+)", r"ATE (\S+) m"))
assert degree or error_m, "prints no figure"
assert not degree or 0.1 < float(degree[1]) < 0.9, "neither the ends of the corridor nor its middle are seen"
assert not error_m or float(error_m[1]) < 1.0, "the path is lost"
