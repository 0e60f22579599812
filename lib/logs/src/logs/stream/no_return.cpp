#include "logs/stream/no_return.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

#include "base/text.hpp"

namespace ddtool {
namespace {

constexpr std::size_t least_repeats = 10;  ///< fewer equal readings may be chance
/// A wall is read at the same distance from one place and in some directions; a code from all places and in many.
constexpr std::uint32_t least_places = 5;
constexpr int least_directions = 8;                ///< of 64
constexpr std::size_t scans_without_motion = 100;  ///< so many are counted even if the robot stands still
constexpr std::size_t most_piles = 1U << 19U;      ///< bounds the memory
constexpr float other_place_m = 0.1F;
constexpr std::size_t other_quantiles = 3;  ///< of 16, that must differ by more at another place
constexpr std::int64_t cluster_mm = 50;
constexpr std::size_t most_in_cluster = 3;
constexpr std::uint32_t least_share_of_peak =
    20;  ///< a value belongs to a pile if it has this part of its peak or more
/// A pile stands out if its readings are times_as_many as those of its neighbours, which lie within this many steps of
/// the lidar's resolution.
constexpr std::int64_t neighbour_steps = 10;
constexpr std::int64_t resolution_window_mm = 500;
constexpr std::uint64_t times_as_many = 4;
constexpr double share_beyond = 1e-3;       ///< of the readings, that may be farther away than a code beyond the echoes
constexpr double least_share_among = 5e-3;  ///< of the readings, that a code among the echoes has at least
constexpr double near_maximum = 0.99;       ///< part of range_max from which a value counts as the maximum itself

std::int64_t millimetres(float range_m) { return std::llround(1e3 * static_cast<double>(range_m)); }

bool is_reading(float range_m) { return std::isfinite(range_m) && range_m > 0.0F && range_m < 1e6F; }

/// Column numbers [first, last) whose value lies in low_mm..high_mm.
template <typename Columns>
std::pair<std::size_t, std::size_t> within(const Columns& columns, std::int64_t low_mm, std::int64_t high_mm) {
    const auto below = [](const auto& column, std::int64_t mm) { return column.millimetres < mm; };
    const auto first = std::lower_bound(columns.begin(), columns.end(), low_mm, below);
    const auto last = std::lower_bound(first, columns.end(), high_mm + 1, below);
    return {static_cast<std::size_t>(first - columns.begin()), static_cast<std::size_t>(last - columns.begin())};
}

/// The usual distance between neighbouring values that were read near a value: the step of the lidar's resolution.
template <typename Columns>
std::int64_t resolution_mm(const Columns& columns, std::int64_t around_mm) {
    const auto [first, last] = within(columns, around_mm - resolution_window_mm, around_mm + resolution_window_mm);
    std::vector<std::int64_t> steps;
    for (std::size_t i = first + 1; i < last; ++i) {
        steps.push_back(columns[i].millimetres - columns[i - 1].millimetres);
    }
    if (steps.empty()) {
        return 1;
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return std::min(*middle, cluster_mm);
}

}  // namespace

std::optional<double> NoReturns::least_beyond_m() const {
    std::optional<double> least_m;
    for (const NoReturnCode& code : codes) {
        if (code.beyond_echoes) {
            least_m = std::min(least_m.value_or(code.value_m), code.value_m);
        }
    }
    return least_m;
}

void NoReturns::apply(LaserScan& scan) const {
    for (const NoReturnCode& code : codes) {
        const std::int64_t code_mm = millimetres(static_cast<float>(code.value_m));
        for (float& range : scan.ranges_m) {
            if (is_reading(range) && millimetres(range) == code_mm) {
                range = code.beyond_echoes ? LaserScan::no_return : LaserScan::invalid;
            }
        }
    }
    if (const std::optional<double> limit_m = least_beyond_m(); limit_m && *limit_m > scan.range_min_m) {
        scan.range_max_m = std::min(scan.range_max_m, *limit_m);
    }
}

std::vector<std::string> NoReturns::lines() const {
    std::vector<std::string> lines;
    for (const NoReturnCode& code : codes) {
        const double share =
            static_cast<double>(code.readings) / static_cast<double>(std::max<std::size_t>(readings, 1));
        lines.push_back("the reading " + fixed_text(code.value_m, 3) + " m (" + std::to_string(code.readings) + " of " +
                        std::to_string(readings) + " readings, " + fixed_text(100.0 * share, 1) + " %) is taken for " +
                        (code.beyond_echoes ? "a beam without return" : "a failed measurement") +
                        "; --no-return names other values, --no-return 0 none");
    }
    return lines;
}

NoReturns named_no_returns(const std::vector<double>& values_m) {
    NoReturns named;
    for (const double value_m : values_m) {
        if (value_m > 0.0) {
            named.codes.push_back({.value_m = value_m});
        }
    }
    return named;
}

std::vector<std::string> RangePiles::never_read(const std::vector<double>& values_m) const {
    std::vector<std::string> lines;
    for (const double value_m : values_m) {
        if (value_m > 0.0 && !piles_.contains(millimetres(static_cast<float>(value_m)))) {
            lines.push_back("--no-return " + fixed_text(value_m, 3) +
                            " has no effect: none of the scans looked at has this reading");
        }
    }
    return lines;
}

void RangePiles::add(const LaserScan& scan) {
    if (!arrive(scan) && scans_ >= scans_without_motion) {
        return;
    }
    ++scans_;
    if (std::isfinite(scan.range_max_m)) {
        range_max_m_ = std::max(range_max_m_, scan.range_max_m);
    }
    const std::size_t beams = scan.ranges_m.size();
    for (std::size_t beam = 0; beam < beams; ++beam) {
        const float range_m = scan.ranges_m[beam];
        if (!is_reading(range_m) || static_cast<double>(range_m) < scan.range_min_m) {
            continue;
        }
        const std::int64_t key = millimetres(range_m);
        if (piles_.size() >= most_piles && !piles_.contains(key)) {
            continue;
        }
        Pile& pile = piles_[key];
        pile.least_m = pile.readings == 0 ? range_m : std::min(pile.least_m, range_m);
        ++pile.readings;
        pile.places += pile.last_place == places_ ? 0 : 1;
        pile.last_place = places_;
        pile.directions |= std::uint64_t{1} << (64 * beam / beams);
    }
}

/// Whether the robot is at another place than at the last arrival. The distribution of the ranges tells, because it
/// does not change when the robot turns. The largest reading is left out, because it may be a code.
bool RangePiles::arrive(const LaserScan& scan) {
    std::vector<float> ranges;
    std::copy_if(scan.ranges_m.begin(), scan.ranges_m.end(), std::back_inserter(ranges), is_reading);
    std::sort(ranges.begin(), ranges.end());
    if (!ranges.empty()) {
        const float echoes_end_m = ranges.back() - 0.001F;
        ranges.erase(std::lower_bound(ranges.begin(), ranges.end(), echoes_end_m), ranges.end());
    }
    Signature signature{};
    for (std::size_t i = 0; i < quantiles && !ranges.empty(); ++i) {
        signature[i] = ranges[(2 * i + 1) * ranges.size() / (2 * quantiles)];
    }
    std::size_t differing = 0;
    for (std::size_t i = 0; i < quantiles; ++i) {
        differing += std::abs(signature[i] - place_[i]) > other_place_m ? 1 : 0;
    }
    if (places_ > 0 && differing < other_quantiles) {
        return false;
    }
    place_ = signature;
    ++places_;
    return true;
}

RangePiles::Columns RangePiles::columns() const {
    Columns columns;
    columns.reserve(piles_.size());
    for (const auto& [mm, pile] : piles_) {
        columns.push_back({mm, pile});
    }
    std::ranges::sort(columns, {}, &Column::millimetres);
    return columns;
}

/// The values within 5 cm of the most frequent one, at most three, that were read about as often; empty if they are no
/// more frequent than their neighbours. Values that are codes already are left out.
std::vector<std::size_t> RangePiles::pile_around(std::size_t peak, const Columns& columns,
                                                 const std::vector<bool>& is_code) {
    const std::int64_t peak_mm = columns[peak].millimetres;
    std::vector<std::size_t> members;
    const auto [first, last] = within(columns, peak_mm - cluster_mm, peak_mm + cluster_mm);
    for (std::size_t i = first; i < last; ++i) {
        // More frequent ones were looked at before and belong to a wall, whose edge must not be judged by them.
        if (!is_code[i] && columns[i].pile.readings <= columns[peak].pile.readings &&
            columns[i].pile.readings * least_share_of_peak >= columns[peak].pile.readings) {
            members.push_back(i);
        }
    }
    const auto readings = [&](std::size_t i) { return columns[i].pile.readings; };
    std::ranges::stable_sort(members, std::greater<>(), readings);
    members.resize(std::min(members.size(), most_in_cluster));
    std::uint64_t others = 0;
    const std::int64_t reach_mm = neighbour_steps * resolution_mm(columns, peak_mm);
    const auto [from, to] = within(columns, peak_mm - reach_mm, peak_mm + reach_mm);
    for (std::size_t i = from; i < to; ++i) {
        others += is_code[i] || std::ranges::count(members, i) > 0 ? 0 : readings(i);
    }
    std::uint64_t together = 0;
    for (const std::size_t member : members) {
        together += readings(member);
    }
    return together >= times_as_many * others ? members : std::vector<std::size_t>{};
}

bool RangePiles::is_believed(const Pile& peak, double share, bool beyond_echoes, bool standing_too) const {
    const double value_m = static_cast<double>(peak.least_m);
    const bool at_maximum = range_max_m_ > 0.0 && value_m >= near_maximum * range_max_m_;
    if (beyond_echoes && (at_maximum || standing_too)) {
        return true;
    }
    const bool is_frequent = share >= least_share_among && std::popcount(peak.directions) >= least_directions;
    return peak.places >= least_places && (beyond_echoes || is_frequent);
}

NoReturns RangePiles::find(bool standing_too) const {
    const Columns columns = this->columns();
    std::vector<std::size_t> by_readings(columns.size());
    std::iota(by_readings.begin(), by_readings.end(), 0);
    std::ranges::stable_sort(by_readings, std::greater<>(), [&](std::size_t i) { return columns[i].pile.readings; });
    std::vector<bool> is_code(columns.size());
    std::vector<std::vector<std::size_t>> clusters;  // of columns, the most frequent one first
    for (const std::size_t peak : by_readings) {
        if (columns[peak].pile.readings < least_repeats) {
            break;
        }
        std::vector<std::size_t> members;
        if (!is_code[peak]) {
            members = pile_around(peak, columns, is_code);
        }
        for (const std::size_t member : members) {
            is_code[member] = true;
        }
        if (!members.empty()) {
            clusters.push_back(std::move(members));
        }
    }
    return chosen(columns, clusters, standing_too);
}

/// The codes among the piles. They are looked at from the largest to the smallest, because a code is beyond the echoes
/// also if other codes are beyond it.
NoReturns RangePiles::chosen(const Columns& columns, std::vector<std::vector<std::size_t>> clusters,
                             bool standing_too) const {
    std::ranges::sort(clusters, std::greater<>(), [](const auto& members) { return members.front(); });
    std::vector<std::uint64_t> up_to(columns.size() + 1);  // readings in all columns before this one
    for (std::size_t i = 0; i < columns.size(); ++i) {
        up_to[i + 1] = up_to[i] + columns[i].pile.readings;
    }
    NoReturns found{.codes = {}, .readings = up_to.back()};
    std::uint64_t codes = 0;
    for (std::vector<std::size_t>& members : clusters) {
        const Pile& peak = columns[members.front()].pile;
        std::ranges::sort(members, std::greater<>());
        const std::uint64_t above = up_to.back() - up_to[members.front() + 1];
        const auto echoes_beyond = static_cast<double>(above - std::min(above, codes));
        const bool beyond = echoes_beyond <= share_beyond * static_cast<double>(up_to.back());
        const double share = static_cast<double>(peak.readings) / static_cast<double>(up_to.back());
        if (!is_believed(peak, share, beyond, standing_too && found.codes.empty())) {
            continue;
        }
        for (const std::size_t member : members) {
            const Pile& pile = columns[member].pile;
            found.codes.push_back({static_cast<double>(pile.least_m), pile.readings, beyond});
            codes += pile.readings;
        }
    }
    return found;
}

}  // namespace ddtool
