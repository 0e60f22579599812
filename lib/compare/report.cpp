#include "compare/report.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/atomic_file.hpp"
#include "compare/result_tables.hpp"

namespace ddtool::compare {
namespace {

std::set<std::string> programs_of(const std::vector<CellResult>& results) {
    std::set<std::string> programs;
    for (const CellResult& result : results) {
        if (result.failure.empty()) {
            programs.insert(result.program);
        }
    }
    return programs;
}

std::string how_to_read(const Experiment& experiment) {
    return "Median over " + std::to_string(experiment.seeds.size()) +
           " seeds [quartiles]; a run that failed counts as an infinite error. * differs from " +
           experiment.methods[experiment.baseline].name() +
           ": Wilcoxon's signed-rank test, paired over seeds, exact, two-sided, below 0.05 after Holm's correction "
           "over all tests of the same error.\n";
}

/// Says so when the experiment is too small to show anything at all.
std::string power_note(const Experiment& experiment) {
    const std::size_t tests = experiment.worlds.size() * (experiment.methods.size() - 1);
    const auto seeds = static_cast<double>(experiment.seeds.size());
    const double least_p = static_cast<double>(tests) * std::exp2(1.0 - seeds);
    if (tests == 0 || least_p < 0.05) {
        return "";
    }
    const auto needed = static_cast<std::size_t>(std::floor(std::log2(static_cast<double>(tests) / 0.05)) + 2.0);
    return "\nNo difference can reach 0.05 here: too few seeds for the number of tests (" + std::to_string(tests) +
           "); " + std::to_string(needed) + " are the fewest.\n";
}

std::string metric_sections(const Experiment& experiment, const std::vector<Summary>& summaries) {
    std::string text;
    for (std::size_t metric = 0; metric < all_metrics().size(); ++metric) {
        const auto is_of = [&](const Summary& summary) { return summary.metric == metric; };
        if (std::any_of(summaries.begin(), summaries.end(), is_of)) {
            const Metric& about = all_metrics()[metric];
            text += "\n## " + about.name + " [" + about.unit + "]\n\n" +
                    metric_table(experiment, summaries, metric).markdown();
        }
    }
    return text;
}

std::string markdown(const Experiment& experiment, const std::vector<Cell>& cells,
                     const std::vector<CellResult>& results, const std::vector<Picture>& pictures) {
    const std::vector<Summary> summaries = summaries_of(experiment, cells, results);
    const Json failures = failure_table(experiment, cells, results).json();
    std::string text = "# Results\n\n" + overview_table(experiment, summaries).markdown() + "\n" +
                       how_to_read(experiment) + power_note(experiment);
    if (!failures.empty()) {
        text += "\n## " + std::to_string(failures.size()) + " of " + std::to_string(cells.size()) + " runs failed\n\n" +
                failure_table(experiment, cells, results).markdown();
    }
    text += metric_sections(experiment, summaries);
    for (const Picture& picture : pictures) {
        text += "\n## " + picture.title + "\n\n![" + picture.title + "](" + picture.file + ")\n";
    }
    const std::set<std::string> programs = programs_of(results);
    return text + "\nComputed by " + joined({programs.begin(), programs.end()}) + ".\n";
}

}  // namespace

Json report_json(const Experiment& experiment, const std::vector<Cell>& cells, const std::vector<CellResult>& results) {
    return {{"baseline", experiment.methods[experiment.baseline].name()},
            {"seeds", experiment.seeds},
            {"rows", full_table(experiment, summaries_of(experiment, cells, results)).json()},
            {"failures", failure_table(experiment, cells, results).json()},
            {"programs", programs_of(results)}};
}

void write_report(const std::filesystem::path& folder, const Experiment& experiment, const std::vector<Cell>& cells,
                  const std::vector<CellResult>& results, const std::vector<Picture>& pictures) {
    const std::vector<Summary> summaries = summaries_of(experiment, cells, results);
    write_file(folder / "results.md", markdown(experiment, cells, results, pictures));
    write_file(folder / "results.csv", full_table(experiment, summaries).csv());
    write_file(folder / "results.json", report_json(experiment, cells, results).dump(2) + "\n");
}

}  // namespace ddtool::compare
