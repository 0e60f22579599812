#include "dataset/snapshot_run.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dataset/drive_window.hpp"
#include "ddtool/logs/log_stream.hpp"
#include "ddtool/methods/driven_scans.hpp"
#include "methods/settings_json.hpp"
#include "robot/scan_information.hpp"
#include "run/snapshot_file.hpp"
#include "scores/statistics.hpp"
#include "sim/simulation_json.hpp"
#include "sim/world_catalogue.hpp"
#include "system/fingerprint.hpp"

namespace ddtool::dataset {
namespace {

using OnProgress = std::function<void(double)>;
/// What a scan tells of the robot's pose, and how well it measures.
struct ScanKnowledge {
    Eigen::Matrix3d information;
    double range_sd_m = 0.0;
};
using Knowledge = std::function<ScanKnowledge()>;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::uint64_t key_of(const PlannedRun& run) { return Fingerprint().add(run.entry.id).value(); }

/// Without the filter, so that filters of other settings see the same piece of the drive.
std::uint64_t key_of_drive(const PlannedRun& run) {
    return Fingerprint().add(run.input).add(run.configuration.at("simulation").dump()).value();
}

SnapshotThinning thinning_of(const PlannedRun& run) {
    return {thinning_from_json(run.configuration.at("thinning")), key_of(run)};
}

Sample sample_of(const ParticleSnapshot& snapshot) {
    Sample sample;
    sample.record.stamp_ns = snapshot.stamp_ns;
    sample.record.update = snapshot.update;
    sample.record.odometry_motion = snapshot.odometry_motion;
    sample.record.true_pose = {unknown, unknown, unknown};
    sample.record.information.fill(unknown);
    sample.record.range_sd_m = unknown;
    sample.record.particle_count = static_cast<std::uint32_t>(snapshot.particles.size());
    sample.particles = snapshot.particles;
    return sample;
}

/// 0 for a scan without returns, which tells nothing anyway.
double median_range_m(const LaserScan& scan) {
    std::vector<double> ranges_m;
    std::copy_if(scan.ranges_m.begin(), scan.ranges_m.end(), std::back_inserter(ranges_m),
                 [](float range_m) { return std::isfinite(range_m); });
    return ranges_m.empty() ? 0.0 : median(ranges_m);
}

/// A swarm that has not moved yet, as at the start of a map, tells nothing of what a scan leaves open.
void offer_moved(SnapshotThinning& thinning, const ParticleSnapshot& swarm, const std::function<Sample()>& make) {
    if (swarm.odometry_motion != Pose2{}) {
        thinning.offer(make);
    }
}

/// A filter whose snapshots become samples.
class Recorder {
public:
    explicit Recorder(const PlannedRun& run)
        : thinning_(thinning_of(run)),
          filter_(make_filter(filter_settings_from_json(run.configuration.at("filter")), DetectorTable(), threads_)) {}

    void process(const SensorFrame& frame, const Knowledge& knowledge) {
        ++scans_;
        const std::optional<Update> update = filter_->update(frame);
        if (!update) {
            return;
        }
        ++updates_;
        offer_moved(thinning_, update->matched, [&] {
            Sample sample = sample_of(update->matched);
            const auto [matrix, range_sd_m] = knowledge();
            sample.record.information = {matrix(0, 0), matrix(0, 1), matrix(0, 2),
                                         matrix(1, 1), matrix(1, 2), matrix(2, 2)};
            sample.record.range_sd_m = range_sd_m;
            sample.record.true_pose = frame.world_from_robot.value_or(sample.record.true_pose);
            return sample;
        });
    }

    [[nodiscard]] std::uint64_t updates() const { return updates_; }

    SnapshotRun finish() { return {thinning_.take(), scans_, thinning_.offered(), 0}; }

private:
    SnapshotThinning thinning_;
    ThreadPool threads_{1};  // many runs at once instead
    std::unique_ptr<Rbpf> filter_;
    std::uint64_t scans_ = 0;
    std::uint64_t updates_ = 0;
};

SnapshotRun filter_world(const PlannedRun& run, const OnProgress& on_progress) {
    const sim::Simulation simulation(sim::load_world(run.input),
                                     sim::simulation_from_json(run.configuration.at("simulation")));
    const DriveWindow window =
        window_of(simulation, run.entry, run.configuration.at("most_particle_updates").get<std::uint64_t>(),
                  RandomStream({key_of_drive(run)}));
    Recorder recorder(run);
    for (std::size_t index = window.first_frame;
         index < simulation.frame_count() && recorder.updates() < window.most_updates; ++index) {
        const sim::SimulatedFrame frame = simulation.frame(index);
        recorder.process(frame.frame, [&]() -> ScanKnowledge {
            return {frame.fisher_information,
                    sim::range_sd_m(simulation.settings().lidar, median_range_m(frame.frame.scan))};
        });
        on_progress(window.share_done(recorder.updates()));
    }
    return recorder.finish();
}

SnapshotRun filter_log(const PlannedRun& run, const OnProgress& on_progress) {
    std::uint64_t problems = 0;
    const auto range_sd_m = run.configuration.at("range_sd_m").get<double>();
    const RbpfSettings filter = filter_settings_from_json(run.configuration.at("filter")).rbpf;
    DrivenScans scans(open_log(run.input, LogOptions{}, [&](const LogProblem&) { ++problems; }), filter);
    Recorder recorder(run);
    while (const std::optional<SensorFrame> frame = scans.next()) {
        recorder.process(*frame, [&]() -> ScanKnowledge {
            return {scan_information(scan_points(*frame, filter.points), range_sd_m), range_sd_m};
        });
        on_progress(scans.fraction_read());
    }
    SnapshotRun made = recorder.finish();
    made.log_problems = problems;
    return made;
}

SnapshotRun read_recorded(const PlannedRun& run, const OnProgress& on_progress) {
    SnapshotRun made;
    SnapshotReader reader(run.input, [&](const LogProblem&) { ++made.log_problems; });
    SnapshotThinning thinning = thinning_of(run);
    while (const std::optional<RecordedSnapshot> recorded = reader.next()) {
        offer_moved(thinning, recorded->snapshot, [&] { return sample_of(recorded->snapshot); });
        on_progress(reader.fraction_read());
    }
    made.snapshots = thinning.offered();
    made.samples = thinning.take();
    return made;
}

}  // namespace

SnapshotRun make_run(const PlannedRun& run, const OnProgress& on_progress) {
    if (run.configuration.contains("world")) {
        return filter_world(run, on_progress);
    }
    return run.configuration.contains("log") ? filter_log(run, on_progress) : read_recorded(run, on_progress);
}

}  // namespace ddtool::dataset
