#include "train/history.hpp"

#include <array>
#include <string>

#include "report/figure.hpp"
#include "report/table.hpp"
#include "system/atomic_file.hpp"
#include "system/folder.hpp"
#include "train/event_file.hpp"

namespace ddtool::train {
namespace {

/// A curve over the epochs. The curves of one group share a panel of the picture and a section in TensorBoard.
struct Curve {
    std::size_t group;
    const char* name;
    double EpochRecord::*value;
};
constexpr std::array<const char*, 4> groups{"loss", "accuracy", "validation", "schedule"};
constexpr std::array<Curve, 7> curves{{{0, "train", &EpochRecord::train_loss},
                                       {0, "validation", &EpochRecord::validation_loss},
                                       {1, "train", &EpochRecord::train_accuracy},
                                       {1, "validation", &EpochRecord::validation_accuracy},
                                       {2, "f1", &EpochRecord::validation_f1},
                                       {2, "auc", &EpochRecord::validation_auc},
                                       {3, "learning_rate", &EpochRecord::learning_rate}}};

Table table_of(const std::vector<EpochRecord>& epochs) {
    const Json names = EpochRecord();
    std::vector<Table::Column> columns;
    for (const auto& [name, value] : names.items()) {
        columns.push_back({name});
    }
    Table table(std::move(columns));
    for (const EpochRecord& epoch : epochs) {
        std::vector<Table::Cell> cells;
        const Json values = epoch;
        for (const Json& value : values) {
            if (value.is_number_float()) {
                cells.emplace_back(value.get<double>());
            } else {
                cells.emplace_back(value.get<std::int64_t>());
            }
        }
        table.add_row(std::move(cells));
    }
    return table;
}

template <typename Value>
std::vector<double> over_epochs(const std::vector<EpochRecord>& epochs, Value EpochRecord::*value) {
    std::vector<double> values;
    values.reserve(epochs.size());
    for (const EpochRecord& epoch : epochs) {
        values.push_back(static_cast<double>(epoch.*value));
    }
    return values;
}

void draw_curves(const std::filesystem::path& file, const std::vector<EpochRecord>& epochs) {
    constexpr std::size_t columns = 2;
    report::Figure figure({.row_shares = {1.0, 1.0}, .columns = columns});
    const std::vector<double> numbers = over_epochs(epochs, &EpochRecord::epoch);
    std::array<std::size_t, groups.size()> drawn{};
    for (const Curve& curve : curves) {
        const report::Colour colour = report::series_colour(drawn[curve.group]++);
        const std::vector<double> values = over_epochs(epochs, curve.value);
        figure.axes(curve.group / columns, curve.group % columns)
            .title(groups[curve.group])
            .x_label("epoch")
            .line(numbers, values, {.label = curve.name, .colour = colour})
            // also draws points, because the line of a single epoch would not be visible
            .scatter(numbers, values, {.label = "", .colour = colour});
    }
    figure.write_png(file);
}

std::vector<StepScalars> scalars_of(const std::vector<EpochRecord>& epochs) {
    std::vector<StepScalars> steps;
    for (const EpochRecord& epoch : epochs) {
        StepScalars& step =
            steps.emplace_back(StepScalars{epoch.wall_time_s, static_cast<std::int64_t>(epoch.epoch), {}});
        for (const Curve& curve : curves) {
            step.values.emplace_back(std::string(groups[curve.group]) + "/" + curve.name, epoch.*curve.value);
        }
    }
    return steps;
}

}  // namespace

void write_history(const std::filesystem::path& folder, const std::vector<EpochRecord>& epochs) {
    made_folder(folder);
    const Table table = table_of(epochs);
    write_file(folder / "metrics.csv", table.csv());
    write_file(folder / "metrics.json", table.json().dump(2) + "\n");
    draw_curves(folder / "curves.png", epochs);
    write_event_file(folder / event_file_name, scalars_of(epochs));
}

}  // namespace ddtool::train
