#include "dataset/scene_split.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <string>

namespace ddtool::dataset {
namespace {

constexpr std::array<double, 3> shares{0.6, 0.2, 0.2};

/// An assignment of the scenes to the parts, with its cost.
class Assignment {
public:
    explicit Assignment(const std::vector<SceneCounts>& scenes) : scenes_(scenes), place_(scenes.size(), nowhere) {
        for (const SceneCounts& scene : scenes) {
            for (std::size_t group = 0; group < scene.size(); ++group) {
                totals_[group] += static_cast<double>(scene[group]);
            }
        }
    }

    [[nodiscard]] std::size_t place(std::size_t scene) const { return place_[scene]; }

    void move(std::size_t scene, std::size_t part) {
        add(scene, place_[scene], -1.0);
        add(scene, part, 1.0);
        place_[scene] = part;
    }

    /// The sum of the squared deviations from the shares 6:2:2. Each class of each rule counts alike, however many
    /// samples it has.
    [[nodiscard]] double cost() const {
        double sum = 0.0;
        for (std::size_t part = 0; part < used_parts.size(); ++part) {
            for (std::size_t group = 0; group < totals_.size(); ++group) {
                const double deviation =
                    totals_[group] == 0.0 ? 0.0 : filled_[part][group] / totals_[group] - shares[part];
                sum += deviation * deviation;
            }
        }
        return sum;
    }

    /// The cost that would result from moving the scene to this part.
    double cost_with(std::size_t scene, std::size_t part) {
        const std::size_t before = place_[scene];
        move(scene, part);
        const double result = cost();
        move(scene, before);
        return result;
    }

    void move_to_best(std::size_t scene) {
        std::size_t best = 0;
        for (std::size_t part = 1; part < used_parts.size(); ++part) {
            if (cost_with(scene, part) < cost_with(scene, best)) {
                best = part;
            }
        }
        move(scene, best);
    }

    static constexpr std::size_t nowhere = used_parts.size();

private:
    void add(std::size_t scene, std::size_t part, double sign) {
        for (std::size_t group = 0; part != nowhere && group < totals_.size(); ++group) {
            filled_[part][group] += sign * static_cast<double>(scenes_[scene][group]);
        }
    }

    const std::vector<SceneCounts>& scenes_;
    std::vector<std::size_t> place_;
    std::array<double, 4> totals_{};
    std::array<std::array<double, 4>, 3> filled_{};
};

std::vector<std::size_t> largest_first(const std::vector<SceneCounts>& scenes) {
    const auto size = [&](std::size_t scene) {
        return std::accumulate(scenes[scene].begin(), scenes[scene].end(), std::size_t{0});
    };
    std::vector<std::size_t> order(scenes.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
    return order;
}

constexpr double least_gain = 1e-12;  // ensures that rounding errors cannot keep the search going for ever

bool improve_by_moves(Assignment& assignment, std::size_t scenes) {
    const double before = assignment.cost();
    for (std::size_t scene = 0; scene < scenes; ++scene) {
        assignment.move_to_best(scene);
    }
    return assignment.cost() < before - least_gain;
}

bool improve_by_swaps(Assignment& assignment, std::size_t scenes) {
    const double before = assignment.cost();
    for (std::size_t a = 0; a < scenes; ++a) {
        for (std::size_t b = a + 1; b < scenes; ++b) {
            const std::size_t place_a = assignment.place(a);
            const std::size_t place_b = assignment.place(b);
            const double cost = assignment.cost();
            assignment.move(a, place_b);
            assignment.move(b, place_a);
            if (assignment.cost() >= cost - least_gain) {
                assignment.move(a, place_a);
                assignment.move(b, place_b);
            }
        }
    }
    return assignment.cost() < before - least_gain;
}

}  // namespace

std::vector<Part> parts_of_scenes(const std::vector<SceneCounts>& scenes) {
    Assignment assignment(scenes);
    for (const std::size_t scene : largest_first(scenes)) {
        assignment.move_to_best(scene);
    }
    while (improve_by_moves(assignment, scenes.size()) || improve_by_swaps(assignment, scenes.size())) {
    }
    std::vector<Part> result;
    result.reserve(scenes.size());
    for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
        result.push_back(used_parts[assignment.place(scene)]);
    }
    return result;
}

void hold_out_scenes(std::span<SampleRecord> records, const std::vector<RunEntry>& runs) {
    std::map<std::string, std::size_t> numbers;
    for (const RunEntry& run : runs) {
        numbers.try_emplace(run.scene, numbers.size());
    }
    const auto scene_of = [&](const SampleRecord& record) { return numbers.at(runs[record.run].scene); };
    const auto is_chosen = [](const SampleRecord& record, LabelRule rule) {
        return record.part_of(rule, Split::paper) != Part::unused;
    };
    std::vector<SceneCounts> counts(numbers.size());
    for (const SampleRecord& record : records) {
        for (const LabelRule rule : all_label_rules) {
            if (is_chosen(record, rule)) {
                ++counts[scene_of(record)][2 * index_of(rule) + (record.label_of(rule) == Label::degenerate ? 1U : 0U)];
            }
        }
    }
    const std::vector<Part> scene_parts = parts_of_scenes(counts);
    for (SampleRecord& record : records) {
        for (const LabelRule rule : all_label_rules) {
            if (is_chosen(record, rule)) {
                record.part[index_of(rule)][index_of(Split::held_out)] = scene_parts[scene_of(record)];
            }
        }
    }
}

}  // namespace ddtool::dataset
