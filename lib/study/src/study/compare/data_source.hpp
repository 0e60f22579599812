#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "ddtool/logs/log_problem.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::compare {

/// The scans that every method of a comparison gets, and where the truth about them is.
struct DataSource {
    /// The frames from the start, each time anew; safe to call from many threads.
    std::function<std::unique_ptr<SensorStream>(const LogProblemHandler& on_problem)> open;
    std::string reference_file;  ///< true trajectory (TUM); empty: what the frames say
    std::string relations_file;  ///< true relative poses; empty: none
    Json identity;               ///< everything that decides the frames and the truth
};

/// A world of an experiment before its seed is known.
class WorldEntry {
public:
    /// From an item of `worlds`, a name or an object (docs/compare.md). `simulation` holds the settings of the
    /// experiment for all worlds. Throws UsageError naming `where` and the key.
    WorldEntry(const Json& item, const Json& simulation, const std::string& where);

    [[nodiscard]] const std::string& name() const { return name_; }
    /// Throws UsageError for a simulated world that does not exist; a log that cannot be read shows when it is opened.
    [[nodiscard]] DataSource data(std::uint64_t seed) const;

private:
    [[nodiscard]] DataSource simulated(std::uint64_t seed) const;
    [[nodiscard]] DataSource logged() const;

    std::string name_;
    Json settings_;
};

}  // namespace ddtool::compare
