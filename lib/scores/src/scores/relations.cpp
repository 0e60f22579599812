#include "scores/relations.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "base/text.hpp"
#include "system/row_file.hpp"

namespace ddtool {
namespace {

std::optional<Relation> parse_relation(std::string_view line) {
    const std::optional<std::int64_t> from = parse_stamp(next_word(line));
    const std::optional<std::int64_t> to = parse_stamp(next_word(line));
    std::array<double, 6> values{};
    for (double& value : values) {
        const std::optional<double> number = parse_number(next_word(line));
        if (!number) {
            return std::nullopt;
        }
        value = *number;
    }
    if (!from || !to || !next_word(line).empty()) {
        return std::nullopt;
    }
    const auto [x, y, z, roll, pitch, yaw] = values;
    return Relation{*from, *to, {x, y, yaw}};
}

/// The errors of some relations.
struct Errors {
    std::vector<double> m;
    std::vector<double> deg;

    void add(double error_m, double error_deg) {
        m.push_back(error_m);
        deg.push_back(error_deg);
    }
    [[nodiscard]] std::optional<RelationStatistics> statistics() const {
        return m.empty() ? std::nullopt : std::optional(RelationStatistics{error_statistics(m), error_statistics(deg)});
    }
};

}  // namespace

std::vector<Relation> read_relations(const std::filesystem::path& path) {
    std::vector<Relation> relations;
    for_each_row(path, "eight numbers 'time1 time2 x y z roll pitch yaw' (relations)", [&](std::string_view line) {
        const std::optional<Relation> relation = parse_relation(line);
        if (relation) {
            relations.push_back(*relation);
        }
        return relation.has_value();
    });
    return relations;
}

RelationErrors score_relations(const Trajectory& trajectory, const std::vector<Relation>& relations,
                               double max_time_difference_s) {
    const StampIndex index(trajectory);
    RelationErrors result;
    Errors short_ones;
    Errors long_ones;
    for (const Relation& relation : relations) {
        const auto from = index.nearest(relation.from_ns, max_time_difference_s);
        const auto to = index.nearest(relation.to_ns, max_time_difference_s);
        if (!from || !to) {
            ++result.skipped;
            continue;
        }
        const Pose2 error = between(between(trajectory[*from].pose, trajectory[*to].pose), relation.motion);
        result.from_ns.push_back(relation.from_ns);
        const double error_m = std::hypot(error.x_m, error.y_m);
        const double error_deg = std::abs(error.theta_rad) * 180.0 / std::numbers::pi;
        result.errors_m.push_back(error_m);
        result.errors_deg.push_back(error_deg);
        const double apart_s =
            1e-9 * std::abs(static_cast<double>(relation.to_ns) - static_cast<double>(relation.from_ns));
        if (apart_s < RelationErrors::most_short_s) {
            short_ones.add(error_m, error_deg);
        } else if (apart_s > RelationErrors::least_long_s) {
            long_ones.add(error_m, error_deg);
        }
    }
    result.all = {error_statistics(result.errors_m), error_statistics(result.errors_deg)};
    result.short_ones = short_ones.statistics();
    result.long_ones = long_ones.statistics();
    return result;
}

}  // namespace ddtool
