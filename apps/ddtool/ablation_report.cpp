#include "ablation_report.hpp"

#include <algorithm>
#include <iostream>

#include "study/ablation/tables.hpp"
#include "system/atomic_file.hpp"
#include "system/log.hpp"

namespace ddtool {
namespace {

ablation::Plan read_plan(const std::string& file) {
    Json json = ablation::default_plan_json();
    merge_settings_file(json, file);
    try {
        return ablation::plan_from_json(json);
    } catch (const UsageError& error) {
        throw UsageError(file + ": " + error.what());
    }
}

template <typename Result>
std::ptrdiff_t failures(const std::vector<Result>& results) {
    return std::count_if(results.begin(), results.end(), [](const Result& each) { return !each.failure.empty(); });
}

}  // namespace

ExitCode run_ablation(const train::Engine& engine, const std::string& plan_file, const std::filesystem::path& data,
                      const std::filesystem::path& folder, const ablation::Machine& machine, bool as_json) {
    const ablation::Plan plan = read_plan(plan_file);
    const ablation::ModelStore store(engine, data, folder / "models", machine);
    const std::vector<ablation::RowResult> rows = run_rows(plan, store);
    const std::vector<ablation::TimingResult> timings = run_timings(plan, rows, store.data(), engine);
    const Table accuracy = accuracy_table(plan, rows);
    const Table times = timing_table(plan, timings);
    const Json json{{"plan", plan_file}, {"rows", accuracy.json()}, {"times", times.json()}};
    write_file(folder / "ablation.json", json.dump(2) + "\n");
    write_file(folder / "ablation.md", accuracy.markdown() + "\n" + times.markdown());
    std::cout << (as_json ? json.dump(2) + "\n" : accuracy.text() + "\n" + times.text());
    const std::ptrdiff_t skipped = failures(rows) + failures(timings);
    if (skipped > 0) {
        log_warning(std::to_string(skipped) + " rows could not be run here: their notes say why");
        return ExitCode::done_with_loss;
    }
    return ExitCode::done;
}

}  // namespace ddtool
