#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "ddtool/robot/laser_scan.hpp"

namespace ddtool {

/// One value that a lidar reports in place of a range, in a log that does not say so.
struct NoReturnCode {
    double value_m = 0.0;
    std::size_t readings = 0;  ///< how often it was read
    /// Hardly any echo is farther away. The beam then had no return, and the space along it is free; a value among the
    /// echoes says nothing of the beam.
    bool beyond_echoes = true;
};

/// The values of a log that are not ranges.
struct NoReturns {
    std::vector<NoReturnCode> codes;  ///< from the largest to the smallest
    std::size_t readings = 0;         ///< all readings that were counted, codes and echoes

    /// The smallest of the codes beyond the echoes, in metres.
    [[nodiscard]] std::optional<double> least_beyond_m() const;
    /// Turns the codes of a scan into LaserScan::no_return or LaserScan::invalid, and lowers range_max_m to the least
    /// code beyond the echoes, because the space farther away was not seen. Ranges are as logged.
    void apply(LaserScan& scan) const;
    /// One line for each code: its value, its count, and what it is taken for.
    [[nodiscard]] std::vector<std::string> lines() const;
};

/// The codes that a user names, in metres; they are all taken for beams without a return. Values that are not positive
/// are left out.
NoReturns named_no_returns(const std::vector<double>& values_m);

/// Finds the values that a lidar reports where a beam has no return, from the readings of a log.
///
/// A code is always the same value to the millimetre, while echoes spread: seen from a distance d, a wall gives
/// readings from d up, of which the number below d + x grows with the square root of x. At most three values that lie
/// within 5 cm are therefore codes if they were read at least ten times, and four times as often as all other values
/// within ten steps of the lidar's resolution on either side (10 cm where the resolution is 1 cm). A robot that stands
/// still sees the same ranges again and again, and its own mast wherever it is. So codes must also have been read at
/// five places at least, unless they are at the lidar's maximum range; and codes that are among the echoes in an
/// eighth of the directions and half a percent of the readings.
class RangePiles {
public:
    /// \param scan ranges as logged; range_min_m and range_max_m as stated, 0 or NaN where they are not
    void add(const LaserScan& scan);
    /// \param standing_too whether the largest reading, with those within 5 cm, may be a code even if the robot has
    /// always stood at one place
    [[nodiscard]] NoReturns find(bool standing_too) const;
    /// One line for each of these values that is positive and was never read: as a code it changes nothing.
    [[nodiscard]] std::vector<std::string> never_read(const std::vector<double>& values_m) const;

private:
    static constexpr std::size_t quantiles = 16;
    using Signature = std::array<float, quantiles>;

    struct Pile {
        float least_m = 0.0F;
        std::uint32_t readings = 0;
        std::uint32_t places = 0;
        std::uint32_t last_place = 0;
        std::uint64_t directions = 0;  ///< one bit for each 64th part of the scan
    };
    struct Column {
        std::int64_t millimetres = 0;
        Pile pile;
    };

    using Columns = std::vector<Column>;

    bool arrive(const LaserScan& scan);
    [[nodiscard]] Columns columns() const;
    [[nodiscard]] static std::vector<std::size_t> pile_around(std::size_t peak, const Columns& columns,
                                                              const std::vector<bool>& is_code);
    [[nodiscard]] NoReturns chosen(const Columns& columns, std::vector<std::vector<std::size_t>> clusters,
                                   bool standing_too) const;
    [[nodiscard]] bool is_believed(const Pile& peak, double share, bool beyond_echoes, bool standing_too) const;

    std::unordered_map<std::int64_t, Pile> piles_;  ///< by the reading in whole millimetres
    Signature place_{};
    std::uint32_t places_ = 0;
    std::size_t scans_ = 0;  ///< counted
    double range_max_m_ = 0.0;
};

}  // namespace ddtool
