#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "ddtool/logs/log_problem.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::compare {

/// The scans that every contestant receives, and where the truth about them is found.
struct DataSource {
    /// Opens a new stream of the frames, from the start. Safe to call from many threads.
    std::function<std::unique_ptr<SensorStream>(const LogProblemHandler& on_problem)> open;
    std::string reference_file;  ///< true trajectory (TUM); empty: the true poses in the frames are used
    std::string relations_file;  ///< true relative poses; empty: there are none
    Json identity;               ///< everything that decides the frames and the truth
};

/// A world of an experiment before its seed is chosen.
class WorldEntry {
public:
    /// From an item of `worlds`, a name or an object (docs/compare.md). `simulation` holds the settings of the
    /// experiment for all worlds. Throws UsageError naming `where` and the key.
    WorldEntry(const Json& item, const Json& simulation, const std::string& where);

    [[nodiscard]] const std::string& name() const { return name_; }
    /// Throws UsageError for a simulated world that does not exist. A log that cannot be read fails only when it is
    /// opened.
    [[nodiscard]] DataSource data(std::uint64_t seed) const;

private:
    struct Simulated {
        std::string pattern;  ///< the world's name or file, with {seed} in it where each seed has its own
        Json simulation;      ///< all settings but the seed
    };
    struct Logged {
        std::string log;
        std::string reference;
        std::string relations;
    };

    [[nodiscard]] DataSource data_of(const Simulated& source, std::uint64_t seed) const;
    [[nodiscard]] DataSource data_of(const Logged& source, std::uint64_t seed) const;

    std::string name_;
    std::variant<Simulated, Logged> source_;
};

}  // namespace ddtool::compare
