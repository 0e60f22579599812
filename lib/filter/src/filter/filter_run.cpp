#include "ddtool/filter/filter_run.hpp"

#include <optional>

namespace ddtool {
namespace {

std::optional<SensorFrame> timed_next(SensorStream& stream, double& seconds) {
    const StageTimer timer(seconds);
    return stream.next();
}

void feed(SensorStream& stream, Rbpf& filter, const FrameObserver& observe, FilterRun& run) {
    bool wanted = true;
    while (wanted) {
        const std::optional<SensorFrame> frame = timed_next(stream, run.read_s);
        if (!frame) {
            break;
        }
        const bool moved = filter.process(*frame);
        if (frame->world_from_robot) {
            run.ground_truth.push_back({frame->scan.stamp_ns, *frame->world_from_robot});
        }
        wanted = observe(*frame, moved);
    }
}

}  // namespace

FilterRun run_filter(SensorStream& stream, Rbpf& filter, const FrameObserver& observe) {
    FilterRun run;
    try {
        feed(stream, filter, observe, run);
    } catch (const MapTooLarge& reason) {
        if (filter.updates() == 0) {
            throw;
        }
        run.ended_early = reason.what();
    }
    if (!filter.particles().empty()) {
        run.map = filter.best().grid;
    }
    run.trajectory = filter.trajectory();
    run.updates = filter.updates();
    run.resamplings = filter.resamplings();
    run.times = filter.times();
    return run;
}

}  // namespace ddtool
