#include "logs/messages/carmen_message.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "logs/messages/readings.hpp"

namespace ddtool {
namespace {

constexpr double rad_per_degree = std::numbers::pi / 180.0;

/// Reads the words of one line as numbers. As soon as a word is missing or invalid, ok() becomes false and stays so.
class Fields {
public:
    explicit Fields(std::string_view words) : words_(words) {}

    double number() { return keep(parse_number(next_word(words_))); }
    std::int64_t stamp() { return keep(parse_stamp(next_word(words_))); }
    [[nodiscard]] std::optional<std::int64_t> stamp_if_any() { return parse_stamp(next_word(words_)); }
    void skip_word() { ok_ = !next_word(words_).empty() && ok_; }
    void skip_numbers(std::size_t count) {
        for (std::size_t i = 0; i < count && ok_; ++i) {
            number();
        }
    }
    Pose2 pose() {
        const double x = number();
        const double y = number();
        ok_ = ok_ && std::abs(x) < farthest_m && std::abs(y) < farthest_m;
        return {x, y, number()};
    }
    /// Reads a count of values that follow in the same line. A value takes at least two characters with its separator,
    /// so a count that the line cannot hold is invalid.
    std::size_t count() {
        const double value = number();
        const std::size_t most = words_.size() / 2;
        ok_ = ok_ && value >= 0.0 && value == std::floor(value) && value <= static_cast<double>(most);
        return ok_ ? static_cast<std::size_t>(value) : 0;
    }
    [[nodiscard]] bool ok() const { return ok_; }

private:
    template <typename Value>
    Value keep(const std::optional<Value>& value) {
        ok_ = ok_ && value.has_value();
        return value.value_or(Value{});
    }

    std::string_view words_;
    bool ok_ = true;
};

std::vector<float> read_ranges(Fields& fields) {
    std::vector<float> ranges(fields.count());
    for (float& range : ranges) {
        range = static_cast<float>(fields.number());
    }
    return ranges;
}

struct SickView {
    std::size_t intervals;
    double half_view_degrees;
};

std::optional<SickView> known_sick_view(std::size_t beams) {
    constexpr std::array<SickView, 3> known{{{180, 90.0}, {360, 90.0}, {400, 50.0}}};
    for (const SickView& view : known) {
        if (beams == view.intervals || beams == view.intervals + 1) {
            return view;
        }
    }
    return std::nullopt;
}

SickView sick_view(std::size_t beams) {
    if (const std::optional<SickView> known = known_sick_view(beams)) {
        return *known;
    }
    return {std::max<std::size_t>(beams, 2) - 1, 90.0};
}

void set_flaser_angles(LaserScan& scan) {
    const SickView view = sick_view(scan.ranges_m.size());
    scan.angle_min_rad = -view.half_view_degrees * rad_per_degree;
    scan.angle_increment_rad = -2.0 * scan.angle_min_rad / static_cast<double>(view.intervals);
}

/// Reads the end that every message has. The name of the host is required, because a line that is cut off within the
/// time before it must not be accepted.
std::optional<CarmenScan> finish(Fields& fields, CarmenScan message) {
    message.scan.stamp_ns = fields.stamp();
    fields.skip_word();
    message.logger_time_ns = fields.stamp_if_any();
    if (!fields.ok() || message.scan.ranges_m.empty()) {
        return std::nullopt;
    }
    return message;
}

}  // namespace

bool is_sick_view(std::size_t beams) { return known_sick_view(beams).has_value(); }

std::optional<CarmenScan> parse_flaser(std::string_view words) {
    Fields fields(words);
    CarmenScan message;
    message.scan.ranges_m = read_ranges(fields);
    set_flaser_angles(message.scan);
    message.odom_from_laser = fields.pose();
    message.odom_from_robot = fields.pose();
    return finish(fields, std::move(message));
}

std::optional<CarmenScan> parse_robotlaser(std::string_view words) {
    Fields fields(words);
    CarmenScan message;
    fields.number();  // laser type
    message.scan.angle_min_rad = fields.number();
    const double field_of_view_rad = fields.number();
    const double resolution_rad = fields.number();
    message.scan.range_max_m = fields.number();
    fields.skip_numbers(2);  // accuracy, remission mode
    message.scan.ranges_m = read_ranges(fields);
    const double intervals = static_cast<double>(std::max<std::size_t>(message.scan.ranges_m.size(), 2) - 1);
    message.scan.angle_increment_rad = resolution_rad != 0.0 ? resolution_rad : field_of_view_rad / intervals;
    fields.skip_numbers(fields.count());  // remissions
    message.odom_from_laser = fields.pose();
    message.odom_from_robot = fields.pose();
    fields.skip_numbers(5);  // tv, rv, safety distances, turn axis
    return finish(fields, std::move(message));
}

bool looks_like_carmen(std::string_view head) {
    constexpr std::array<std::string_view, 8> names{"FLASER ", "RLASER ",    "ODOM ",    "PARAM ",
                                                    "SYNC ",   "ROBOTLASER", "RAWLASER", "TRUEPOS "};
    while (!head.empty()) {
        const std::string_view line = head.substr(0, head.find('\n'));
        if (std::any_of(names.begin(), names.end(), [&](std::string_view name) { return line.starts_with(name); })) {
            return true;
        }
        head.remove_prefix(std::min(line.size() + 1, head.size()));
    }
    return false;
}

}  // namespace ddtool
