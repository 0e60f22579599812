#include "logs/messages/carmen_message.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/text.hpp"
#include "logs/messages/readings.hpp"

namespace ddtool {
namespace {

constexpr double rad_per_degree = std::numbers::pi / 180.0;

/// Reads the words of one line as numbers. As soon as a word is missing or invalid, ok() becomes false and stays so,
/// and fault() says which word it was.
class Fields {
public:
    explicit Fields(std::string_view words) : words_(words) {}

    double number() { return keep(parse_number(next()), "a number"); }
    /// A reading of a beam, which may also be inf (no return) or nan.
    float reading() {
        const std::string_view word = next();
        float special = 0.0F;
        const auto [end, error] = std::from_chars(word.begin(), word.end(), special);
        if (error == std::errc() && end == word.end() && !std::isfinite(special)) {
            return special;
        }
        return static_cast<float>(keep(parse_number(word), "a range in metres"));
    }
    std::int64_t stamp() { return keep(parse_stamp(next()), "a time in seconds"); }
    [[nodiscard]] std::optional<std::int64_t> stamp_if_any() { return parse_stamp(next()); }
    void skip_word() { expect(!next().empty(), "the name of the host"); }
    void skip_numbers(std::size_t count) {
        for (std::size_t i = 0; i < count && ok(); ++i) {
            number();
        }
    }
    Pose2 pose() {
        const double x = coordinate();
        const double y = coordinate();
        return {x, y, number()};
    }
    /// Reads a count of values that follow in the same line. A value takes at least two characters with its separator,
    /// so a count that the line cannot hold is invalid.
    std::size_t count() {
        const double value = number();
        const std::size_t most = words_.size() / 2;
        expect(value >= 0.0 && value == std::floor(value) && value <= static_cast<double>(most),
               "the number of the values that follow in the line");
        return ok() ? static_cast<std::size_t>(value) : 0;
    }
    [[nodiscard]] bool ok() const { return fault_.empty(); }
    /// "word 7 is '1,53', expected a number"; empty while all is well.
    [[nodiscard]] const std::string& fault() const { return fault_; }

private:
    /// Not the comma, which separates words elsewhere: some programs write it for a decimal point.
    static constexpr std::string_view blanks = " \t\r";

    std::string_view next() {
        ++number_;
        const std::size_t begin = std::min(words_.find_first_not_of(blanks), words_.size());
        const std::size_t end = std::min(words_.find_first_of(blanks, begin), words_.size());
        word_ = words_.substr(begin, end - begin);
        words_.remove_prefix(end);
        return word_;
    }
    double coordinate() {
        const double value = number();
        expect(std::abs(value) < farthest_m, "a position in metres");
        return value;
    }
    void expect(bool is_met, const char* expected) {
        if (ok() && !is_met) {
            constexpr std::size_t most_shown = 20;
            const std::string found(word_.substr(0, most_shown));
            const bool has_comma = word_.find(',') != std::string_view::npos;
            fault_ = (word_.empty() ? "it ends before word " + std::to_string(number_)
                                    : "word " + std::to_string(number_) + " is '" + found + "'") +
                     ", expected " + expected + (has_comma ? " with a decimal point" : "");
        }
    }
    template <typename Value>
    Value keep(const std::optional<Value>& value, const char* expected) {
        expect(value.has_value(), expected);
        return value.value_or(Value{});
    }

    std::string_view words_;
    std::string_view word_;   ///< the one read last
    std::size_t number_ = 1;  ///< of that word in the line, whose first is the message's name
    std::string fault_;
};

std::vector<float> read_ranges(Fields& fields) {
    std::vector<float> ranges(fields.count());
    for (float& range : ranges) {
        range = fields.reading();
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
CarmenLine finish(Fields& fields, CarmenScan message) {
    message.scan.stamp_ns = fields.stamp();
    fields.skip_word();
    message.logger_time_ns = fields.stamp_if_any();
    if (!fields.ok()) {
        return {std::nullopt, fields.fault()};
    }
    if (message.scan.ranges_m.empty()) {
        return {std::nullopt, "it has 0 readings"};
    }
    return {std::move(message), ""};
}

}  // namespace

bool is_sick_view(std::size_t beams) { return known_sick_view(beams).has_value(); }

CarmenLine parse_flaser(std::string_view words) {
    Fields fields(words);
    CarmenScan message;
    message.scan.ranges_m = read_ranges(fields);
    set_flaser_angles(message.scan);
    message.odom_from_laser = fields.pose();
    message.odom_from_robot = fields.pose();
    return finish(fields, std::move(message));
}

CarmenLine parse_robotlaser(std::string_view words) {
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
