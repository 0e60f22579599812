#include "dataset/snapshot_run.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dataset/drive_window.hpp"
#include "ddtool/logs/log_stream.hpp"
#include "ddtool/methods/driven_scans.hpp"
#include "robot/scan_information.hpp"
#include "run/snapshot_file.hpp"
#include "scores/statistics.hpp"
#include "sim/world_catalogue.hpp"
#include "system/fingerprint.hpp"

namespace ddtool::dataset {
namespace {

using OnProgress = std::function<void(double)>;
/// The Fisher information about the robot's pose that a scan contains, and the noise of its ranges.
struct ScanKnowledge {
    Eigen::Matrix3d information;
    double range_sd_m = 0.0;
};
using Knowledge = std::function<ScanKnowledge()>;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::uint64_t key_of(const PlannedRun& run) { return Fingerprint().add(run.entry.id).value(); }

SnapshotThinning thinning_of(const PlannedRun& run) { return {run.thinning, key_of(run)}; }

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

/// The median of the finite ranges, or 0 for a scan without returns. Such a scan contains no information anyway.
double median_range_m(const LaserScan& scan) {
    std::vector<double> ranges_m;
    std::copy_if(scan.ranges_m.begin(), scan.ranges_m.end(), std::back_inserter(ranges_m),
                 [](float range_m) { return std::isfinite(range_m); });
    return ranges_m.empty() ? 0.0 : median(ranges_m);
}

/// Offers the swarm to the thinning if the robot has moved since the update before. At the start of a map it has not,
/// and such a swarm does not show what a scan leaves open.
void offer_moved(SnapshotThinning& thinning, const ParticleSnapshot& swarm, const std::function<Sample()>& make) {
    if (swarm.odometry_motion != Pose2{}) {
        thinning.offer(make);
    }
}

/// Runs a filter and turns its snapshots into samples.
class Recorder {
public:
    Recorder(const PlannedRun& run, const FilterSettings& filter)
        : thinning_(thinning_of(run)), filter_(make_filter(filter, DetectorTable(), threads_)) {}

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
    ThreadPool threads_{1};  // one thread, because many runs are made at once
    std::unique_ptr<ParticleFilter> filter_;
    std::uint64_t scans_ = 0;
    std::uint64_t updates_ = 0;
};

SnapshotRun make(const WorldRun& source, const PlannedRun& run, const OnProgress& on_progress) {
    const sim::Simulation simulation(sim::load_world(source.world), source.simulation);
    const DriveWindow window =
        window_of(simulation, run.entry, source.most_particle_updates, RandomStream({source.drive_key}));
    Recorder recorder(run, source.filter);
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

SnapshotRun make(const LogRun& source, const PlannedRun& run, const OnProgress& on_progress) {
    std::uint64_t problems = 0;
    const RbpfSettings& filter = source.filter.rbpf;
    DrivenScans scans(open_log(source.path, LogOptions{}, [&](const LogProblem&) { ++problems; }), filter);
    Recorder recorder(run, source.filter);
    while (const std::optional<SensorFrame> frame = scans.next()) {
        recorder.process(*frame, [&]() -> ScanKnowledge {
            return {scan_information(scan_points(*frame, filter.points), source.range_sd_m), source.range_sd_m};
        });
        on_progress(scans.fraction_read());
    }
    SnapshotRun made = recorder.finish();
    made.log_problems = problems;
    return made;
}

SnapshotRun make(const RecordedRun& source, const PlannedRun& run, const OnProgress& on_progress) {
    SnapshotRun made;
    SnapshotReader reader(source.path, [&](const LogProblem&) { ++made.log_problems; });
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
    return std::visit([&](const auto& source) { return make(source, run, on_progress); }, run.source);
}

}  // namespace ddtool::dataset
