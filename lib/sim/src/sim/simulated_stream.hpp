#pragma once

#include <memory>
#include <utility>

#include "ddtool/robot/scan_truth.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "sim/simulation.hpp"

namespace ddtool::sim {

/// A simulation as a stream of frames for the filter, without a file in between.
class SimulatedStream : public SensorStream {
public:
    SimulatedStream(const World& world, const SimulationSettings& settings) : simulation_(world, settings) {}

    std::optional<SensorFrame> next() override;
    [[nodiscard]] double fraction_read() const override;
    void tell_truth(const std::shared_ptr<ScanTruth>& truth) override { truth_ = truth; }

    [[nodiscard]] const Simulation& simulation() const { return simulation_; }

private:
    Simulation simulation_;
    std::size_t next_ = 0;
    std::shared_ptr<ScanTruth> truth_;
};

}  // namespace ddtool::sim
