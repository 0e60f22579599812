"""Slam, its detectors, and the life of what it hands out."""

import gc
import json
import math
import os
import pickle
import signal
import sys
import threading
import time
import unittest
import weakref

import numpy as np

import ddtool
from support import InFolder, command


def bytes_of(trajectory):
    return trajectory.stamps_ns.tobytes() + trajectory.poses.tobytes()


def eigenvalue(points, weights):
    """The larger eigenvalue of the weighted covariance, unbiased, as the detector covariance has it."""
    mean = weights @ points
    centred = points - mean
    covariance = (weights[:, None] * centred).T @ centred / max(1e-300, 1.0 - np.sum(weights**2))
    return np.linalg.eigvalsh(covariance)[-1]


class SameAsTheCommand(InFolder):
    def test_path_and_map_have_the_same_bytes(self):
        for method in ("anti-degeneracy", "gmapping"):
            run = self.folder / method
            command("slam", "--log", self.log, "--method", method, "--particles", 8, "--seed", 5, "--out", run)
            for threads in (1, 2):
                slam = self.new_slam(method=method, threads=threads)
                slam.run(ddtool.open_log(self.log)).write(self.folder / "path.tum")
                slam.map().write(self.folder / "map.yaml")
                self.assertEqual((self.folder / "path.tum").read_bytes(), (run / "trajectory.tum").read_bytes())
                self.assertEqual((self.folder / "map.pgm").read_bytes(), (run / "map.pgm").read_bytes())

    def test_without_odometry_too(self):
        run = self.folder / "by-scans"
        command("slam", "--log", self.log, "--odometry", "none", "--particles", 8, "--seed", 5, "--out", run)
        slam = self.new_slam()
        for scan in ddtool.open_log(self.log, settings={"log": {"odometry": "none"}}):
            self.assertEqual(scan.odom_step, "unknown")
            slam.update(scan)
        slam.trajectory().write(self.folder / "path.tum")
        self.assertEqual((self.folder / "path.tum").read_bytes(), (run / "trajectory.tum").read_bytes())

    def test_settings_of_a_run_fit(self):
        run = self.folder / "configured"
        command("slam", "--log", self.log, "--particles", 6, "--set", "filter.update_distance_m=0.3", "--out", run)
        settings = json.loads((run / "config.json").read_text())
        slam = ddtool.Slam(settings=settings)
        self.assertEqual(slam.settings, settings)
        slam.run(ddtool.open_log(self.log, settings=settings)).write(self.folder / "path.tum")
        self.assertEqual((self.folder / "path.tum").read_bytes(), (run / "trajectory.tum").read_bytes())


class Detectors(InFolder):
    def path_with(self, detector, **settings):
        slam = self.new_slam(detector=detector, settings=settings)
        return bytes_of(slam.run(self.simulation)), slam

    def test_a_callable_that_computes_the_same_gives_the_same_bytes(self):
        builtin = ddtool.Detector("covariance")
        expected, _ = self.path_with("covariance")
        self.assertEqual(self.path_with(builtin)[0], expected)
        degrees = []

        def by_numpy(swarm):
            value = eigenvalue(swarm.poses[:, :2], swarm.weights)
            degrees.append((value / (value + 0.1**2), builtin(swarm)))
            return round(degrees[-1][0], 6)

        settings = {"filter.gate": "none"}
        path, _ = self.path_with(by_numpy, **settings)
        self.assertEqual(self.path_with(lambda swarm: round(builtin(swarm), 6), **settings)[0], path)
        self.assertGreater(max(degree for degree, _ in degrees), 0.01)
        np.testing.assert_allclose(*zip(*degrees), atol=1e-9)

    @staticmethod
    def without_truth(scan):
        return ddtool.Scan(scan.ranges, angle_min_rad=scan.angle_min_rad, angle_increment_rad=scan.angle_increment_rad,
                           range_max_m=scan.range_max_m, stamp_ns=scan.stamp_ns, odom_from_robot=scan.odom_from_robot)

    def test_the_degree_that_is_returned_is_the_one_that_acts(self):
        always, _ = self.path_with(lambda swarm: 1, **{"filter.gate": "none"})
        self.assertEqual(always, self.path_with("always")[0])
        never, _ = self.path_with(lambda swarm: np.float32(0.0), **{"filter.gate": "none"})
        self.assertEqual(never, self.path_with("none")[0])
        self.assertNotEqual(always, never)

    def test_a_direction_is_passed_on(self):
        slam = self.new_slam(detector=lambda swarm: (0.25, 0.5), settings={"filter.gate": "none"})
        slam.run(self.simulation, on_update=(updates := []).append)
        self.assertEqual({(update.degree, update.direction_rad) for update in updates[1:]}, {(0.25, 0.5)})

    def test_oracle_knows_simulated_scans_and_simulated_logs(self):
        degrees = []
        for scans in (self.simulation, ddtool.open_log(self.log)):
            slam = self.new_slam(detector="oracle")
            slam.run(scans, on_update=lambda update: degrees.append(update.degree))
        self.assertGreater(max(degrees[: len(degrees) // 2]), 0.5)
        self.assertGreater(max(degrees[len(degrees) // 2 :]), 0.5)
        with self.assertRaisesRegex(ddtool.Error, "simulat"):
            self.new_slam(detector="oracle").run(self.without_truth(scan) for scan in self.simulation)

    def test_what_it_raises_comes_out_of_update_and_the_filter_goes_on(self):
        calls = []

        def fails_once(swarm):
            calls.append(swarm)
            if len(calls) == 3:
                raise KeyError("lost")
            return 0.0

        slam = self.new_slam(detector=fails_once, settings={"filter.gate": "none"})
        raised = 0
        for scan in self.simulation:
            try:
                slam.update(scan)
            except KeyError as error:
                self.assertEqual(error.args, ("lost",))
                self.assertIn("fails_once", str(error.__traceback__.tb_next.tb_frame.f_code.co_name))
                raised += 1
        self.assertEqual(raised, 1)
        # The failed update counts as one of degree 0.
        self.assertEqual(bytes_of(slam.trajectory()), self.path_with("none")[0])

    def test_answers_that_are_no_degree_are_refused(self):
        for answer, error, text in ((math.nan, ValueError, "the degree nan"), (1.5, ddtool.UsageError, "the degree 1.5"),
                                    ("0.5", TypeError, "returned str"), (None, TypeError, "returned NoneType"),
                                    ((0.5, math.inf), ValueError, "direction"), ((1, 2, 3), TypeError, "tuple"),
                                    ([0.5, 1], TypeError, "list")):
            slam = self.new_slam(detector=lambda swarm: answer, settings={"filter.gate": "none"})
            with self.subTest(answer=answer), self.assertRaisesRegex(error, text):
                slam.run(self.simulation)

    def test_a_detector_cannot_use_the_slam_that_asks_it(self):
        slam = self.new_slam(detector=lambda swarm: slam.pose[0], settings={"filter.gate": "none"})
        with self.assertRaisesRegex(ddtool.Error, "cannot use the object that asks it"):
            slam.run(self.simulation)

    def test_a_swarm_may_be_kept(self):
        kept = []
        slam = self.new_slam(detector=lambda swarm: kept.append(swarm.poses) or 0, settings={"filter.gate": "none"})
        copies = []
        slam.run(self.simulation, on_update=lambda update: copies.append(update.swarm.poses.copy()))
        del slam
        gc.collect()
        for poses, copy in zip(kept, copies[1:], strict=True):
            np.testing.assert_array_equal(poses, copy)

    def test_a_cycle_through_the_callable_is_collected(self):
        class Owner:
            def __init__(self, slam):
                self.slam = slam(detector=self.degree)

            def degree(self, swarm):
                return 0.0

        owner = Owner(self.new_slam)
        owner.slam.update(self.simulation[0])
        gone = weakref.ref(owner)
        del owner
        gc.collect()
        self.assertIsNone(gone())


class Lifetimes(InFolder):
    def updates(self):
        updates = []
        slam = self.new_slam()
        slam.run(self.simulation, on_update=updates.append)
        return slam, updates

    def test_views_outlive_everything(self):
        slam, updates = self.updates()
        arrays = [updates[5].pose, updates[5].covariance, updates[5].swarm.poses, updates[5].swarm.particles,
                  updates[5].corrected.weights, slam.map().log_odds, slam.map().occupancy, slam.trajectory().poses,
                  slam.trajectory().stamps_ns, self.simulation[3].ranges]
        copies = [array.copy() for array in arrays]
        del slam, updates
        gc.collect()
        np.random.default_rng(1).random(1 << 20)  # takes memory that was freed
        for array, copy in zip(arrays, copies):
            np.testing.assert_array_equal(array, copy)

    def test_later_updates_change_no_view(self):
        slam = self.new_slam()
        first = slam.update(self.simulation[0])
        arrays = [first.pose, first.swarm.poses, slam.map().log_odds, slam.trajectory().poses]
        copies = [array.copy() for array in arrays]
        slam.run(self.simulation)
        for array, copy in zip(arrays, copies):
            np.testing.assert_array_equal(array, copy)

    def test_nothing_is_copied_and_nothing_can_be_written(self):
        slam, updates = self.updates()
        swarm = updates[-1].swarm
        self.assertTrue(np.shares_memory(swarm.poses, swarm.particles))
        self.assertTrue(np.shares_memory(updates[-1].swarm.weights, swarm.particles))
        np.testing.assert_array_equal(swarm.particles[:, :3], swarm.poses)
        np.testing.assert_array_equal(swarm.particles[:, 12], swarm.weights)
        for array in (swarm.poses, updates[0].pose, updates[0].covariance, slam.map().occupancy,
                      slam.trajectory().poses, slam.trajectory().stamps_ns, self.simulation[0].ranges):
            with self.assertRaises(ValueError):
                array[...] = 0
            with self.assertRaises(ValueError):
                array.flags.writeable = True

    def test_shapes(self):
        slam, updates = self.updates()
        self.assertEqual(updates[3].pose.shape, (3,))
        self.assertEqual(updates[3].covariance.shape, (3, 3))
        self.assertEqual(updates[3].swarm.poses.shape, (8, 3))
        self.assertEqual(len(updates[3].swarm), 8)
        self.assertAlmostEqual(updates[3].swarm.weights.sum(), 1.0)
        self.assertEqual(updates[3].swarm.update, updates[3].number)
        self.assertEqual(slam.trajectory().poses.shape, (len(self.simulation), 3))
        self.assertEqual(slam.map().log_odds.shape, slam.map().occupancy.shape)
        np.testing.assert_array_equal(slam.map().log_odds > 0, slam.map().occupancy == 100)
        np.testing.assert_array_equal(slam.map().log_odds == -128, slam.map().occupancy == -1)
        # The wall at y = -1 is where the rows say it is.
        grid, (_, bottom_m) = slam.map(), slam.map().origin_m
        row = np.argmax((grid.occupancy == 100).sum(axis=1))
        start = self.simulation.truth().poses[0]
        self.assertAlmostEqual(abs(bottom_m + (row + 0.5) * grid.resolution_m + start[1]), 1.0, delta=0.1)
        np.testing.assert_array_equal(slam.pose, slam.trajectory().poses[-1])
        self.assertTrue(np.all(np.linalg.eigvalsh(slam.covariance) >= 0.0))


class Threads(InFolder):
    def test_two_slams_in_two_threads(self):
        expected = [bytes_of(self.new_slam(seed=seed).run(self.simulation)) for seed in (1, 2)]
        found = {}

        def work(seed):
            degrees = []
            slam = self.new_slam(seed=seed, threads=2, detector=ddtool.Detector("ddmodel-lite"))
            found[seed] = bytes_of(slam.run(self.simulation, on_update=lambda update: degrees.append(update.degree)))

        threads = [threading.Thread(target=work, args=(seed,)) for seed in (1, 2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([found[1], found[2]], expected)

    def test_one_slam_in_two_threads_is_not_torn(self):
        slam = self.new_slam()
        scans = list(self.simulation)
        threads = [threading.Thread(target=slam.run, args=(scans[half::2],)) for half in (0, 1)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(slam.trajectory()), len(scans))

    def test_others_go_on_while_it_works(self):
        slam = self.new_slam(particles=200)
        slam.update(self.simulation[0])
        switches, done = [0], threading.Event()

        def count():
            while not done.is_set():
                switches[0] += 1
                time.sleep(0)

        sys.setswitchinterval(10.0)  # so that the counter only runs where the GIL is released
        counter = threading.Thread(target=count)
        try:
            counter.start()
            before = switches[0]
            slam.run(list(self.simulation)[1:])
            self.assertGreater(switches[0], before + 1)
        finally:
            done.set()
            sys.setswitchinterval(0.005)
            counter.join()

    def test_fork(self):
        shared, alone = self.new_slam(threads=2), self.new_slam(threads=1)
        shared.update(self.simulation[0])
        child = os.fork()
        if child == 0:
            status = 1
            try:
                alone.run(self.simulation)
                fresh = self.new_slam(threads=2)
                fresh.run(self.simulation)
                try:
                    shared.update(self.simulation[1])
                except ddtool.Error as error:
                    status = 0 if "os.fork" in str(error) else 2
                del shared
                gc.collect()
            finally:
                os._exit(status)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 0)

    def test_ctrl_c_ends_a_run_and_keeps_the_path(self):
        slam = self.new_slam()

        def interrupt(update):
            if update.number == 5:
                os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            slam.run(self.simulation, on_update=interrupt)
        self.assertTrue(5 <= len(slam.trajectory()) < len(self.simulation))
        self.assertIsNotNone(slam.map())


class Localisation(InFolder):
    def test_same_as_the_command_in_a_map_of_both_kinds(self):
        run = self.folder / "run"
        command("slam", "--log", self.log, "--particles", 8, "--out", run)
        start = self.simulation.odometry().poses[0]
        for number, file in enumerate((run / "map.ddmap", run / "map.yaml", run)):
            out = self.folder / f"localized-{number}"
            command("localize", "--map", file, "--log", self.log, "--initial-pose", ",".join(map(str, start)),
                    "--seed", 3, "--out", out)
            updates = []
            localizer = ddtool.localize(file, start, seed=3)
            localizer.run(ddtool.open_log(self.log), on_update=updates.append)
            localizer.trajectory().write(self.folder / "path.tum")
            self.assertEqual((self.folder / "path.tum").read_bytes(), (out / "trajectory.tum").read_bytes())
            self.assertGreater(updates[-1].standing.probability, 0.5)
            self.assertGreater(updates[-1].standing.support, 0.5)
        self.assertIsNone(self.new_slam().update(self.simulation[0]).standing)
        np.testing.assert_array_equal(ddtool.read_map(run / "map.ddmap").occupancy, ddtool.read_map(run).occupancy)

    def test_a_callable_detector_is_asked(self):
        slam = self.new_slam()
        slam.run(self.simulation)
        slam.map().write(self.folder / "m.yaml")
        asked = []
        ddtool.localize(self.folder / "m.yaml", (0, 0, 0), detector=lambda swarm: asked.append(len(swarm)) or 0.0,
                        settings={"filter.gate": "none"}).run(self.simulation)
        self.assertGreater(len(asked), 10)


class Pickling(InFolder):
    def test_scans_swarms_and_trajectories_survive(self):
        scan = self.simulation[4]
        again = pickle.loads(pickle.dumps(scan))
        self.assertEqual(again.ranges.tobytes(), scan.ranges.tobytes())
        np.testing.assert_array_equal(again.fisher_information, scan.fisher_information)
        np.testing.assert_array_equal(again.world_from_robot, scan.world_from_robot)
        slam = self.new_slam()
        scans = pickle.loads(pickle.dumps(list(self.simulation)))
        self.assertEqual(bytes_of(slam.run(scans)), bytes_of(self.new_slam().run(self.simulation)))
        path = pickle.loads(pickle.dumps(slam.trajectory()))
        self.assertEqual(bytes_of(path), bytes_of(slam.trajectory()))
        swarm = self.new_slam().update(self.simulation[0]).swarm
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(swarm)).particles, swarm.particles)

    def test_what_cannot_be_pickled_says_so(self):
        for thing in (self.new_slam(), ddtool.open_log(self.log)):
            with self.assertRaisesRegex(TypeError, "pickle"):
                pickle.dumps(thing)


if __name__ == "__main__":
    unittest.main()
