#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace ddtool {

/// Counts scans whose stamp is more than ten seconds away from that of the scan before, while the next scan goes on
/// from there: a single damaged stamp, or an old scan that was delivered late. A clock that is set, and a pause, are
/// none, since the scans after them go on from the new time.
class StrayStamps {
public:
    /// What is known of a scan, and of the one of its lidar before it.
    struct Found {
        bool is_suspect = false;        ///< the next scan tells whether this one is a stray
        bool before_was_stray = false;  ///< the scan before was suspect, and this one does not go on from it
    };

    /// \param lidar each lidar has stamps of its own
    Found add(std::int64_t stamp_ns, std::size_t lidar);
    /// One line about all strays so far; empty if there are none.
    [[nodiscard]] std::string finding() const;

private:
    struct Course {
        std::int64_t believed_ns = 0;
        std::optional<std::int64_t> suspect_ns;
        std::size_t suspect_number = 0;
        std::size_t seen = 0;
    };

    void count(std::size_t number, double apart_s);

    std::map<std::size_t, Course> courses_;  ///< by lidar
    std::size_t strays_ = 0;
    std::size_t first_number_ = 0;  ///< of the scans of its lidar
    double first_apart_s_ = 0.0;
};

}  // namespace ddtool
