#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "ddtool/methods/detector_table.hpp"
#include "ddtool/methods/method.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::compare {

/// Estimates a trajectory: receives every frame of a log in order and returns in the end where the robot was.
class Estimator {
public:
    Estimator() = default;
    virtual ~Estimator() = default;
    Estimator(const Estimator&) = delete;
    Estimator& operator=(const Estimator&) = delete;

    virtual void process(const SensorFrame& frame) = 0;
    /// Returns the trajectory in a world frame of the estimator's own. Throws Error if there is no trajectory.
    virtual Trajectory trajectory() = 0;
};

/// One of the things that an experiment compares (an item of its `methods`), before world and seed are chosen: our
/// filter with any of its methods and settings, the odometry, another program's trajectories, or the bound that a known
/// map sets.
class Contestant {
public:
    /// From an item of `methods` (docs/compare.md). `filter` holds the settings of the experiment for all filters.
    /// Throws UsageError naming `where` and the key.
    Contestant(const Json& item, const Json& filter, const std::string& where, DetectorTable detectors);

    [[nodiscard]] const std::string& name() const { return name_; }
    /// Whether it is optional and has no file for any of these worlds and seeds.
    [[nodiscard]] bool is_absent(const std::vector<std::string>& worlds, const std::vector<std::uint64_t>& seeds) const;
    /// Returns everything that, together with the data, decides the trajectory.
    [[nodiscard]] Json identity(const std::string& world, std::uint64_t seed) const;
    /// Creates an estimator. truth: what the stream tells whose frames the estimator will receive
    /// (SensorStream::tell_truth()).
    [[nodiscard]] std::unique_ptr<Estimator> start(const std::string& world, std::uint64_t seed,
                                                   std::shared_ptr<const ScanTruth> truth) const;

private:
    struct Filter {
        FilterSettings settings;  ///< without the seed
        Json json;                ///< the same, as configured
    };
    struct Odometry {};
    struct External {
        std::string trajectories;  ///< path of TUM files, with {world} and {seed} in it
        bool optional = false;     ///< it may be left out where none of them is there
    };
    struct KnownMap {
        std::string odometry;  ///< name of an odometry preset of the simulator
    };
    using Kind = std::variant<Filter, Odometry, External, KnownMap>;

    static Kind kind_from(const Json& settings, const std::string& kind, const std::string& where);

    std::string name_;
    Kind kind_;
    DetectorTable detectors_;
};

}  // namespace ddtool::compare
