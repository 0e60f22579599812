#include "ablation_report.hpp"

#include <algorithm>
#include <iostream>
#include <thread>

#include "builtin_plans.hpp"
#include "study/ablation/reduced_plan.hpp"
#include "study/ablation/tables.hpp"
#include "system/atomic_file.hpp"
#include "system/log.hpp"

namespace ddtool {
namespace {

ablation::Plan paper_plan() {
    Json json = ablation::default_plan_json();
    merge_settings(json, parse_json(paper_ablation_plan(), paper_ablation_name, /*comments=*/true),
                   paper_ablation_name);
    return ablation::plan_from_json(json);
}

ablation::Plan plan_in(const std::string& file) {
    Json json = ablation::default_plan_json();
    merge_settings_file(json, file);
    try {
        return ablation::plan_from_json(json);
    } catch (const UsageError& error) {
        throw UsageError(file + ": " + error.what());
    }
}

ablation::Plan reduced_plan(const ablation::Machine& machine) {
    const ablation::Plan whole = paper_plan();
    if (machine.device != "cpu") {
        log_info("a GPU is there: the paper's table is trained whole");
        return whole;
    }
    const std::size_t cores =
        machine.threads > 0 ? machine.threads : std::max<std::size_t>(1, std::thread::hardware_concurrency());
    ablation::Plan plan = ablation::reduced_plan(whole, cores);
    log_info("the paper's table at the size that " + std::to_string(cores) + " cores can train: " +
             ablation::reductions(whole, plan) + ". The whole of it: --ablation paper, on a GPU with --device cuda");
    return plan;
}

template <typename Result>
std::ptrdiff_t failures(const std::vector<Result>& results) {
    return std::count_if(results.begin(), results.end(), [](const Result& each) { return !each.failure.empty(); });
}

}  // namespace

ablation::Plan read_ablation_plan(const std::string& name, const ablation::Machine& machine) {
    if (name == reduced_plan_name) {
        return reduced_plan(machine);
    }
    return name == "paper" ? paper_plan() : plan_in(name);
}

ExitCode run_ablation(const train::Engine& engine, const std::string& plan_name, const ablation::Plan& plan,
                      const std::filesystem::path& data, const std::filesystem::path& folder,
                      const ablation::Machine& machine, bool as_json) {
    const ablation::ModelStore store(engine, data, folder / "models", machine);
    const std::vector<judge::Evaluation> rules = run_rules(plan, store.data());
    const std::vector<ablation::RowResult> rows = run_rows(plan, store);
    const std::vector<ablation::TimingResult> timings = run_timings(plan, rows, store.data(), engine);
    const Table accuracy = accuracy_table(plan, rows, rules);
    const Table times = timing_table(plan, timings);
    const Json json{{"plan", plan_name}, {"rows", accuracy.json()}, {"times", times.json()}};
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
