#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "ddtool/methods/detector_table.hpp"
#include "ddtool/methods/method.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::compare {

/// Estimates a trajectory: takes every frame of a log and says in the end where the robot was.
class Estimator {
public:
    Estimator() = default;
    virtual ~Estimator() = default;
    Estimator(const Estimator&) = delete;
    Estimator& operator=(const Estimator&) = delete;

    virtual void process(const SensorFrame& frame) = 0;
    /// In a world frame of its own. Throws Error where there is none.
    virtual Trajectory trajectory() = 0;
};

/// What is compared, an item of an experiment's `methods`, before world and seed are known: our filter with any of its
/// methods and settings, odometry, another program's trajectories, or the bound that a known map sets.
class Contestant {
public:
    /// From an item of `methods` (docs/compare.md). `filter` holds the settings of the experiment for all filters.
    /// Throws UsageError naming `where` and the key.
    Contestant(const Json& item, const Json& filter, const std::string& where, DetectorTable detectors);

    [[nodiscard]] const std::string& name() const { return name_; }
    /// Everything that, with the data, decides the trajectory.
    [[nodiscard]] Json identity(const std::string& world, std::uint64_t seed) const;
    /// truth: what the stream tells whose frames the estimator will get (SensorStream::tell_truth()).
    [[nodiscard]] std::unique_ptr<Estimator> start(const std::string& world, std::uint64_t seed,
                                                   std::shared_ptr<const ScanTruth> truth) const;

private:
    struct Filter {
        FilterSettings settings;  ///< all but the seed
        Json json;                ///< the same, as configured
    };
    struct Odometry {};
    struct External {
        std::string trajectories;  ///< path of TUM files, with {world} and {seed} in it
    };
    struct KnownMap {
        std::string odometry;  ///< preset of the simulator
    };
    using Kind = std::variant<Filter, Odometry, External, KnownMap>;

    static Kind kind_from(const Json& settings, const std::string& kind, const std::string& where);

    std::string name_;
    Kind kind_;
    DetectorTable detectors_;
};

}  // namespace ddtool::compare
