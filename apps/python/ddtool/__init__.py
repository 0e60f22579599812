"""Lidar SLAM that sees when it is degenerate, and acts on it.

    import ddtool

    log = ddtool.open_log("office.mcap")
    slam = ddtool.Slam(seed=1)
    for scan in log:
        update = slam.update(scan)
        if update is not None:
            print(update.pose, update.degree)
    slam.map().write("office.yaml")

Lengths are in metres, angles in radians, stamps in nanoseconds. A pose is x, y and heading; world_from_robot is the pose
of the robot in the world. Arrays that belong to ddtool are read-only views without a copy, and keep alive what they show.

What goes wrong is raised: ddtool.Error, of which UsageError is also a ValueError and OutputError an OSError, and
FileNotFoundError. Nothing is printed; messages go to the logger "ddtool" of the module logging.
"""

from ddtool._ddtool import *  # noqa: F401,F403
from ddtool._ddtool import __version__  # noqa: F401
