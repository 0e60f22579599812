"""Ten lines of NumPy in the place of the network: own_detector.py [LOG]; without a log, a simulated corridor.

The degree is the share of the particles' predicted spread that is left after scan matching, along the direction in which
it is largest."""

import sys
from collections.abc import Iterable

import numpy as np

import ddtool


def share_left(swarm: ddtool.Swarm) -> tuple[float, float]:
    left = np.cov(swarm.matched_motions[:, :2].T)  # (2, 2), m^2, in the robot's frame at the last update
    predicted = np.cov(swarm.predicted_motions[:, :2].T)
    variances, axes = np.linalg.eigh(left)  # in rising order
    weakest = axes[:, -1]
    drawn = weakest @ predicted @ weakest
    share = np.sqrt(min(1.0, variances[-1] / drawn)) if drawn > 0.0 else 0.0
    heading = np.median(swarm.poses[:, 2])  # the direction is reported in the world
    return float(share), float(heading + np.arctan2(weakest[1], weakest[0]))


def scans_of(arguments: list[str]) -> Iterable[ddtool.Scan]:
    if arguments:
        return ddtool.open_log(arguments[0])
    return ddtool.simulate("s2", settings={"lidar.rate_hz": 2})


if __name__ == "__main__":
    slam = ddtool.Slam(particles=20, seed=1, detector=share_left, settings={"filter.gate": "none"})
    degrees: list[float] = []
    slam.run(scans_of(sys.argv[1:]), on_update=lambda update: degrees.append(update.degree))
    print(f"{len(degrees)} updates, mean degree {np.mean(degrees):.2f}")
