#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "ddtool/methods/detector_table.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::compare {

/// What is compared: takes every frame of a log and says in the end where the robot was.
class Method {
public:
    Method() = default;
    virtual ~Method() = default;
    Method(const Method&) = delete;
    Method& operator=(const Method&) = delete;

    virtual void process(const SensorFrame& frame) = 0;
    /// In a world frame of its own. Throws Error where there is none.
    virtual Trajectory trajectory() = 0;
};

/// A method of an experiment before world and seed are known.
class MethodEntry {
public:
    /// From an item of `methods` (docs/compare.md). `filter` holds the settings of the experiment for all filters.
    /// Throws UsageError naming `where` and the key.
    MethodEntry(const Json& item, const Json& filter, const std::string& where, DetectorTable detectors);

    [[nodiscard]] const std::string& name() const { return name_; }
    /// Everything that, with the data, decides the trajectory.
    [[nodiscard]] Json identity(const std::string& world, std::uint64_t seed) const;
    /// truth: what the stream tells whose frames the method will get (SensorStream::tell_truth()).
    [[nodiscard]] std::unique_ptr<Method> start(const std::string& world, std::uint64_t seed,
                                                std::shared_ptr<const ScanTruth> truth) const;

private:
    [[nodiscard]] std::string model_fingerprint() const;
    [[nodiscard]] std::string file(const std::string& world, std::uint64_t seed) const;

    std::string name_;
    std::string kind_;
    Json settings_;
    DetectorTable detectors_;
};

}  // namespace ddtool::compare
