"""What the tests of the Python package share: a small world, a log of it, and results of the program ddtool."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import ddtool

DDTOOL = os.environ["DDTOOL"]
# A corridor whose ends are out of range in its middle, so that detectors have something to see.
CORRIDOR = {"name": "corridor", "description": "a corridor with a corner", "start": [-5, 0, 0],
            "way_points": [[5, 0], [5, 3]],
            "walls": [[[-6, -1], [6, -1], [6, 4], [4, 4], [4, 1], [-6, 1], [-6, -1]]]}
SIMULATION = {"lidar.beams": 180, "lidar.range_max_m": 4.0, "lidar.preset": "rplidar-a1"}


def command(*arguments, cwd=None):
    """Runs ddtool. That a result may be doubtful (3) is no failure: the world is small."""
    done = subprocess.run([DDTOOL, "--quiet", *map(str, arguments)], cwd=cwd, stdout=subprocess.PIPE, text=True)
    assert done.returncode in (0, 3), done
    return done.stdout


class InFolder(unittest.TestCase):
    """Tests that share a folder with corridor.json and a log of it, drive.mcap."""

    @classmethod
    def setUpClass(cls):
        cls._folder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls._folder.name)
        cls.world = cls.folder / "corridor.json"
        cls.world.write_text(json.dumps(CORRIDOR))
        cls.simulation = ddtool.simulate(cls.world, seed=3, settings=SIMULATION)
        cls.log = cls.folder / "drive.mcap"
        cls.simulation.write(cls.log)

    @classmethod
    def tearDownClass(cls):
        cls._folder.cleanup()

    def new_slam(self, **arguments):
        return ddtool.Slam(**{"particles": 8, "seed": 5, "threads": 1, **arguments})
