#include "ddtool/filter/filter_run.hpp"

#include <optional>

namespace ddtool {
namespace {

void feed(SensorStream& stream, ParticleFilter& filter, const FrameObserver& observe, FilterRun& run) {
    bool wanted = true;
    while (wanted) {
        const std::optional<SensorFrame> frame = timed(run.read_s, [&] { return stream.next(); });
        if (!frame) {
            break;
        }
        const std::optional<Update> update = filter.update(*frame);
        if (update) {
            ++run.updates;
            run.resamplings += update->resampled ? 1 : 0;
            run.times += update->times;
        }
        if (frame->world_from_robot) {
            run.ground_truth.push_back({frame->scan.stamp_ns, *frame->world_from_robot});
        }
        wanted = observe(*frame, update);
    }
}

}  // namespace

FilterRun run_filter(SensorStream& stream, ParticleFilter& filter, const FrameObserver& observe) {
    FilterRun run;
    try {
        feed(stream, filter, observe, run);
    } catch (const MapTooLarge& reason) {
        if (run.updates == 0) {
            throw;
        }
        run.ended_early = reason.what();
    }
    if (run.updates > 0) {
        run.map = filter.map();
    }
    run.trajectory = filter.trajectory();
    run.odometry = filter.odometry_state();
    return run;
}

}  // namespace ddtool
