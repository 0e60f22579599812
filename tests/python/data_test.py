"""Logs, simulations, scores, images and data sets as arrays."""

import json
import math
import unittest

import numpy as np

import ddtool
from support import InFolder, command


class Logs(InFolder):
    def test_scans_are_those_that_were_simulated(self):
        log = ddtool.open_log(self.log)
        self.assertEqual((log.format, log.scan_topic, log.odom_topic), ("MCAP", "/scan", "/odom"))
        self.assertEqual((log.odom_frame, log.robot_frame, log.ground_truth_topic), ("odom", "base_link", "/ground_truth"))
        scans = list(log)
        self.assertEqual(len(scans), len(self.simulation))
        for scan, simulated in zip(scans, self.simulation):
            np.testing.assert_array_equal(scan.ranges, simulated.ranges)
            self.assertEqual(scan.stamp_ns, simulated.stamp_ns)
            np.testing.assert_allclose(scan.world_from_robot, simulated.world_from_robot, atol=1e-9)
            np.testing.assert_allclose(scan.fisher_information, simulated.fisher_information)
        self.assertEqual((log.scans, log.problems, log.has_odometry), (len(scans), 0, True))

    def test_every_iteration_begins_anew_and_several_go_on_together(self):
        log = ddtool.open_log(self.log)
        pairs = list(zip(log, log))
        self.assertEqual(len(pairs), len(self.simulation))
        self.assertTrue(all(one.stamp_ns == other.stamp_ns for one, other in pairs))

    def test_topics(self):
        topics = {topic.name: topic for topic in ddtool.open_log(self.log).topics()}
        self.assertEqual(topics["/scan"].messages, len(self.simulation))
        self.assertEqual(topics["/scan"].frames, ["laser"])
        self.assertEqual(topics["/odom"].type, "nav_msgs/msg/Odometry")
        self.assertEqual(topics["/tf"].frames, ["odom -> base_link"])
        self.assertGreater(topics["/odom"].rate_hz, topics["/scan"].rate_hz)

    def test_odometry_and_imu_at_their_own_stamps(self):
        simulation = ddtool.simulate(self.world, settings={"imu.rate_hz": 50})
        simulation.write(self.folder / "imu.mcap")
        log = ddtool.open_log(self.folder / "imu.mcap")
        for topic in ("", "/odom", "/tf"):
            odometry = log.odometry(topic)
            np.testing.assert_array_equal(odometry.stamps_ns, simulation.odometry().stamps_ns)
            np.testing.assert_allclose(odometry.poses, simulation.odometry().poses, atol=1e-9)
        imu = log.imu()
        self.assertEqual(imu.angular_velocity.shape, (len(imu.stamps_ns), 3))
        truth = simulation.truth()
        turned = np.sum(imu.angular_velocity[:, 2]) / 50.0
        self.assertAlmostEqual(turned, truth.poses[-1, 2] - truth.poses[0, 2], delta=0.1)
        with self.assertRaises(ValueError):
            imu.stamps_ns[0] = 0
        with self.assertRaisesRegex(ddtool.UsageError, "'/nothing' is no topic"):
            log.odometry("/nothing")
        with self.assertRaisesRegex(ddtool.UsageError, "inertial"):
            ddtool.open_log(self.log).imu()

    def test_the_odometry_of_a_carmen_log_is_in_its_scans(self):
        carmen = self.folder / "a.clf"
        carmen.write_text("".join(f"FLASER 5 2 2.1 2.2 2.1 2 {x} 0 0 {x} 0 0.1 1{x}.5 host {x}\n" for x in range(4)))
        odometry = ddtool.open_log(carmen).odometry()
        np.testing.assert_allclose(odometry.poses, [(x, 0, 0.1) for x in range(4)])
        np.testing.assert_array_equal(odometry.stamps_ns, [(10 + x) * 10**9 + 5 * 10**8 for x in range(4)])

    def test_settings_choose_topics(self):
        log = ddtool.open_log(self.log, settings={"log.odom_topic": "/tf"})
        self.assertEqual(log.odom_topic, "/tf")
        with self.assertRaisesRegex(ddtool.UsageError, "/front"):
            ddtool.open_log(self.log, settings={"log": {"scan_topic": "/front"}})

    def test_damage_is_counted_and_logged(self):
        damaged = self.folder / "damaged.mcap"
        damaged.write_bytes(self.log.read_bytes()[:-20000])
        with self.assertLogs("ddtool", "WARNING") as logged:
            log = ddtool.open_log(damaged)
            scans = sum(1 for _ in log)
        self.assertTrue(0 < scans < len(self.simulation))
        self.assertGreater(log.problems, 0)
        self.assertIn(log.first_problems[0], "\n".join(logged.output))


class Scans(InFolder):
    def test_a_scan_of_ones_own(self):
        scan = ddtool.Scan([1.0, math.nan, math.inf, 9.0, 0.01, 2], angle_min_rad=-1.0, angle_increment_rad=0.5,
                           range_max_m=8.0, range_min_m=0.05, stamp_ns=7, odom_from_robot=(1, 2, 3),
                           robot_from_laser=[0.1, 0, 0])
        self.assertEqual(scan.ranges.dtype, np.float32)
        np.testing.assert_array_equal(scan.ranges, np.array([1, np.nan, np.inf, np.inf, np.nan, 2], np.float32))
        np.testing.assert_allclose(scan.angles_rad, [-1, -0.5, 0, 0.5, 1, 1.5])
        np.testing.assert_allclose(scan.points()[0], [0.1 + math.cos(-1), math.sin(-1)])
        self.assertEqual(scan.points().shape, (2, 2))
        self.assertEqual((len(scan), scan.odom_step, scan.world_from_robot, scan.joined, scan.lidar),
                         (6, "measured", None, [], 0))

    def test_own_scans_map_like_those_of_the_log(self):
        slam, copied = self.new_slam(), self.new_slam()
        for scan in self.simulation:
            slam.update(scan)
            own = ddtool.Scan(scan.ranges, angle_min_rad=scan.angle_min_rad, range_min_m=scan.range_min_m,
                              angle_increment_rad=scan.angle_increment_rad, range_max_m=scan.range_max_m,
                              stamp_ns=scan.stamp_ns, odom_from_robot=scan.odom_from_robot,
                              robot_from_laser=scan.robot_from_laser)
            copied.update(own)
        difference = slam.trajectory().poses - copied.trajectory().poses
        self.assertLess(np.abs(difference).max(), 0.2)  # the sweep of the beams is all that differs

    def test_scans_without_any_return(self):
        slam = self.new_slam()
        for ranges in ([], [math.inf] * 30, [math.nan] * 30):
            for step in range(3):
                slam.update(ddtool.Scan(ranges, angle_min_rad=0.0, angle_increment_rad=0.1, range_max_m=5.0,
                                        stamp_ns=step, odom_from_robot=(0.2 * step, 0, 0)))
        self.assertEqual(len(slam.trajectory()), 9)
        self.assertTrue(np.isfinite(slam.trajectory().poses).all())

    def test_wrong_scans_are_refused(self):
        good = {"ranges": [1.0], "angle_min_rad": 0.0, "angle_increment_rad": 0.1, "range_max_m": 5.0, "stamp_ns": 1}
        for name, value in (("ranges", [[1.0]]), ("ranges", "near"), ("ranges", None), ("angle_min_rad", math.nan),
                            ("range_max_m", -1.0), ("odom_from_robot", (1, 2)), ("odom_from_robot", (1, 2, math.nan)),
                            ("robot_from_laser", "here")):
            with self.subTest(name=name, value=value), self.assertRaisesRegex(ValueError, name):
                ddtool.Scan(**{**good, name: value})
        for name, value in (("stamp_ns", 1.5), ("stamp_ns", "now"), ("range_max_m", None)):
            with self.subTest(name=name, value=value), self.assertRaises(TypeError):
                ddtool.Scan(**{**good, name: value})


class Simulations(InFolder):
    def test_is_a_sequence(self):
        self.assertEqual(len(list(self.simulation)), len(self.simulation))
        self.assertEqual(self.simulation[-1].stamp_ns, self.simulation[len(self.simulation) - 1].stamp_ns)
        with self.assertRaises(IndexError):
            self.simulation[len(self.simulation)]
        np.testing.assert_array_equal(self.simulation.truth().poses[4], self.simulation[4].world_from_robot)

    def test_same_log_as_the_command(self):
        (self.folder / "settings.json").write_text(json.dumps({"lidar": {"preset": "hokuyo-utm-30lx"}}))
        command("simulate", "--world", self.world, "--seed", 3, "--config", self.folder / "settings.json",
                "--out", self.folder / "by-command.mcap")
        ddtool.simulate(self.world, seed=3, settings={"lidar.preset": "hokuyo-utm-30lx"}).write(self.folder / "own.mcap")
        self.assertEqual((self.folder / "own.mcap").read_bytes(), (self.folder / "by-command.mcap").read_bytes())

    def test_worlds_are_named(self):
        self.assertIn("s2", ddtool.worlds())
        with self.assertRaisesRegex(ddtool.UsageError, "s2"):
            ddtool.simulate("s22")
        with self.assertRaises(FileNotFoundError):
            ddtool.simulate("no.json")


class Scores(InFolder):
    def test_of_a_known_error(self):
        truth = self.simulation.truth()
        moved = ddtool.Trajectory(truth.stamps_ns, truth.poses + [0.3, 0.4, 0.0])
        score = ddtool.score(moved, truth, align="none")
        self.assertAlmostEqual(score.ate_m.rmse, 0.5)
        self.assertAlmostEqual(score.error_x_m.mean, 0.3)
        np.testing.assert_allclose(score.errors_m, 0.5)
        np.testing.assert_array_equal(score.stamps_ns, truth.stamps_ns)
        self.assertIsNone(score.relations_m)
        aligned = ddtool.score(moved, truth)
        self.assertAlmostEqual(aligned.ate_m.rmse, 0.0)
        np.testing.assert_allclose(aligned.truth_from_estimate[2], 0.0, atol=1e-9)

    def test_same_as_the_command(self):
        truth = self.simulation.truth()
        truth.write(self.folder / "truth.tum")
        self.simulation.odometry().write(self.folder / "odometry.tum")
        stamps = 1e-9 * truth.stamps_ns[[0, -1]]
        (self.folder / "a.relations").write_text(f"{stamps[0]:.9f} {stamps[1]:.9f} 1 2 0 0 0 0.5\n")
        told = json.loads(command("score", "--json", "--trajectory", "odometry.tum", "--reference", "truth.tum",
                                  "--relations", "a.relations", cwd=self.folder))
        score = ddtool.score(self.folder / "odometry.tum", self.folder / "truth.tum", self.folder / "a.relations")
        self.assertEqual(score.as_dict(), told)
        self.assertEqual(score.relations_m.count, 1)
        self.assertIn("rmse", repr(score.ate_m))

    def test_wrong_arguments(self):
        truth = self.simulation.truth()
        with self.assertRaisesRegex(ValueError, "truth, relations or both"):
            ddtool.score(truth)
        with self.assertRaisesRegex(ValueError, "align"):
            ddtool.score(truth, truth, align="icp")
        with self.assertRaises(TypeError):
            ddtool.score(truth.poses, truth)
        with self.assertRaises(FileNotFoundError):
            ddtool.score(truth, "no.tum")
        later = ddtool.Trajectory(truth.stamps_ns + 10**12, truth.poses)
        with self.assertRaises(ddtool.Error):
            ddtool.score(later, truth)
        for stamps, poses in ((np.array([2**63], np.uint64), [[0, 0, 0]]), ([1.5], [[0, 0, 0]]), ([1, 2], [[0, 0, 0]]), ([1], [[0, 0]]), ([1], [[0, 0, math.nan]])):
            with self.subTest(stamps=stamps, poses=poses), self.assertRaises(ValueError):
                ddtool.Trajectory(stamps, poses)


class Images(InFolder):
    def swarm(self):
        rng = np.random.default_rng(2)
        return ddtool.Swarm(rng.normal(size=(40, 3)), matched_motions=0.1 * rng.normal(size=(40, 3)),
                            predicted_motions=0.1 * rng.normal(size=(40, 3)))

    def test_of_a_swarm_of_ones_own(self):
        image = ddtool.render(self.swarm(), settings={"swarm": "absolute", "size_px": 64, "gaussian_augmentation": False})
        self.assertEqual((image.shape, image.dtype), ((64, 64), np.uint8))
        self.assertEqual(set(np.unique(image)), {0, 255})
        self.assertTrue(0 < np.count_nonzero(image) <= 40)
        image[0, 0] = 7  # belongs to the caller

    def test_wrong_settings_and_swarms(self):
        with self.assertRaisesRegex(ddtool.UsageError, "size_px"):
            ddtool.render(self.swarm(), settings={"sise_px": 64})
        with self.assertRaisesRegex(ddtool.UsageError, "size_px"):
            ddtool.render(self.swarm(), settings={"size_px": 0})
        with self.assertRaises(FileNotFoundError):
            ddtool.render(self.swarm(), detector="no.safetensors")
        for arguments in ({"poses": np.zeros((3, 2))}, {"poses": np.zeros((3, 3)), "weights": [1, 2]},
                          {"poses": np.zeros((2, 3)), "weights": [1, -2]}, {"poses": np.zeros((2, 3)), "weights": [0, 0]}):
            with self.subTest(**arguments), self.assertRaises(ValueError):
                ddtool.Swarm(**arguments)

    def test_detectors_judge_swarms_of_ones_own(self):
        held = ddtool.Swarm(np.zeros((30, 3)), predicted_motions=np.random.default_rng(1).normal(size=(30, 3)))
        self.assertEqual(ddtool.Detector("step-spread")(held), 0.0)
        free = ddtool.Swarm(held.predicted_motions, predicted_motions=held.predicted_motions,
                            matched_motions=held.predicted_motions)
        self.assertEqual(ddtool.Detector("step-spread")(free), 1.0)
        self.assertGreater(ddtool.Detector("ddmodel-lite")(free), 0.5)
        self.assertEqual(ddtool.Detector("none")(free), 0.0)
        with self.assertRaisesRegex(ddtool.UsageError, "covariance"):
            ddtool.Detector("covarience")
        nobody = ddtool.Swarm(np.zeros((0, 3)))
        self.assertEqual((len(nobody), nobody.effective_size, nobody.dispersion), (0, 0.0, 0.0))


class DataSets(InFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "plan.json").write_text(json.dumps(
            {"worlds": [{"world": str(cls.world), "seeds": {"count": 3}}], "mix": {"particles": [4, 5]},
             "simulation": {"lidar": {"beams": 90}}, "thinning": {"every": 2},
             "balance": {"degenerate": 10, "not_degenerate": 10}}))
        command("build-dataset", "--config", "plan.json", "--out", "data", cwd=cls.folder)
        cls.data = ddtool.open_dataset(cls.folder / "data", checksums=True)

    def test_shards_are_the_files(self):
        files = sorted((self.folder / "data").glob("shard-*.samples.npy"))
        self.assertEqual(len(files), len(self.data.shards))
        for file, shard in zip(files, self.data.shards):
            np.testing.assert_array_equal(np.load(file), shard)
            with self.assertRaises(ValueError):
                shard["stamp_ns"][0] = 1
        self.assertEqual(sum(map(len, self.data.shards)), len(self.data))
        records = np.concatenate(self.data.shards)
        np.testing.assert_array_equal(self.data.labels("fisher"), records["label"][:, 1])
        np.testing.assert_array_equal(self.data.dispersion(), records["dispersion"][:, 0])

    def test_a_swarm_is_a_view_of_the_file(self):
        swarm = self.data.swarm(-1)
        self.assertTrue(np.shares_memory(swarm.particles, self.data.particles[-1]))
        record = self.data.shards[-1][-1]
        self.assertEqual(len(swarm), record["particle_count"])
        np.testing.assert_array_equal(swarm.particles, self.data.particles[-1][record["first_particle"]:][:len(swarm)])
        self.assertAlmostEqual(swarm.dispersion, record["dispersion"][0])
        data = ddtool.open_dataset(self.folder / "data")
        poses = data.swarm(0).poses
        del data
        self.assertTrue(np.isfinite(poses).all())

    def test_parts_images_and_runs(self):
        parts = [self.data.part(part, "paper") for part in ("train", "validation", "test", "unused")]
        np.testing.assert_array_equal(np.sort(np.concatenate(parts)), np.arange(len(self.data)))
        images = self.data.images(parts[0], settings={"size_px": 32})
        self.assertEqual(images.shape, (len(parts[0]), 32, 32))
        np.testing.assert_array_equal(images[0], ddtool.render(self.data.swarm(int(parts[0][0])), settings={"size_px": 32}))
        self.assertEqual({run["particles"] for run in self.data.runs} - {4, 5}, set())
        self.assertEqual(self.data.settings["thinning"]["every"], 2)

    def test_wrong_arguments(self):
        with self.assertRaisesRegex(ValueError, "part: expected unused, train"):
            self.data.part("training")
        with self.assertRaisesRegex(ValueError, "rule"):
            self.data.labels("paper")
        with self.assertRaises(IndexError):
            self.data.swarm(len(self.data))
        with self.assertRaises(IndexError):
            self.data.images([len(self.data)])
        with self.assertRaises(FileNotFoundError):
            ddtool.open_dataset(self.folder / "nowhere")
        with self.assertRaisesRegex(ddtool.Error, "manifest.json"):
            ddtool.open_dataset(self.folder)


if __name__ == "__main__":
    unittest.main()
