#pragma once

#include <chrono>

namespace ddtool {

/// Wall time spent in the filter's stages, in seconds.
struct StageTimes {
    double prepare_s = 0.0;
    double match_s = 0.0;
    double detect_s = 0.0;
    double correct_s = 0.0;
    double resample_s = 0.0;
    double map_s = 0.0;
};

/// Adds its own lifetime to a stage.
class StageTimer {
public:
    explicit StageTimer(double& total_s) : total_s_(total_s) {}
    ~StageTimer() { total_s_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

private:
    using Clock = std::chrono::steady_clock;
    double& total_s_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace ddtool
