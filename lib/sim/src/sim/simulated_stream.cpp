#include "sim/simulated_stream.hpp"

#include <utility>

namespace ddtool::sim {

std::optional<SensorFrame> SimulatedStream::next() {
    if (next_ == simulation_.frame_count()) {
        return std::nullopt;
    }
    SimulatedFrame frame = simulation_.frame(next_++);
    if (truth_) {
        truth_->add(frame.frame.scan.stamp_ns, frame.fisher_information);
    }
    return std::move(frame.frame);
}

double SimulatedStream::fraction_read() const {
    return static_cast<double>(next_) / static_cast<double>(simulation_.frame_count());
}

}  // namespace ddtool::sim
