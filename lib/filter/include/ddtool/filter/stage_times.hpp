#pragma once

#include <chrono>

namespace ddtool {

/// Wall time spent in the filter's stages, in seconds.
struct StageTimes {
    double prepare_s = 0.0;  ///< turning the scan into points
    double match_s = 0.0;    ///< propagating the particles and matching the scan to their maps
    double detect_s = 0.0;
    double correct_s = 0.0;
    double resample_s = 0.0;
    double map_s = 0.0;  ///< entering the scan into the particles' maps

    [[nodiscard]] double total_s() const { return prepare_s + match_s + detect_s + correct_s + resample_s + map_s; }
    StageTimes& operator+=(const StageTimes& other) {
        prepare_s += other.prepare_s;
        match_s += other.match_s;
        detect_s += other.detect_s;
        correct_s += other.correct_s;
        resample_s += other.resample_s;
        map_s += other.map_s;
        return *this;
    }
};

/// Adds the wall time of its own lifetime to the time of a stage.
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

/// Runs `work`, adds its wall time to `total_s` and returns its result.
template <typename Work>
decltype(auto) timed(double& total_s, Work work) {
    const StageTimer timer(total_s);
    return work();
}

}  // namespace ddtool
