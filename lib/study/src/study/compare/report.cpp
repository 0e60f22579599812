#include "study/compare/report.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "report/page.hpp"
#include "study/compare/result_tables.hpp"
#include "system/atomic_file.hpp"

namespace ddtool::compare {
namespace {

std::string failures_heading(const std::vector<CellResult>& results) {
    const auto failed =
        std::count_if(results.begin(), results.end(), [](const CellResult& result) { return !result.failure.empty(); });
    return std::to_string(failed) + " of " + std::to_string(results.size()) + " runs failed";
}

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
           experiment.contestants[experiment.baseline].name() +
           ": Wilcoxon's signed-rank test, paired over seeds, exact, two-sided, below 0.05 after Holm's correction "
           "over all tests of the same error.";
}

std::string how_to_read_paper(const Experiment& experiment) {
    return "Medians over the seeds, and what the paper prints for the method of that name. The change is that "
           "against " +
           experiment.contestants[experiment.baseline].name() +
           " with the same seed, its median and quartiles over the seeds; the paper's is that of its figures.";
}

/// A warning if the experiment has too few seeds for any difference to be significant, otherwise an empty text. The
/// smallest possible p-value of the signed-rank test with n seeds is 2^(1-n), and Holm's correction multiplies it by
/// the number of tests.
std::string power_note(const Experiment& experiment) {
    const std::size_t tests = experiment.worlds.size() * (experiment.contestants.size() - 1);
    const auto seeds = static_cast<double>(experiment.seeds.size());
    const double least_p = static_cast<double>(tests) * std::exp2(1.0 - seeds);
    if (tests == 0 || least_p < 0.05) {
        return "";
    }
    const auto needed = static_cast<std::size_t>(std::floor(std::log2(static_cast<double>(tests) / 0.05)) + 2.0);
    return "No difference can reach 0.05 here: too few seeds for the number of tests (" + std::to_string(tests) +
           "); " + std::to_string(needed) + " are the fewest.";
}

/// A section of the report, for every format of output.
struct Section {
    std::string heading;
    std::vector<Table> tables;
    std::vector<std::string> notes;
    std::vector<Picture> pictures;
};

std::vector<Section> sections_of(const Experiment& experiment, const std::vector<Cell>& cells,
                                 const std::vector<CellResult>& results, const std::vector<Picture>& pictures) {
    const std::vector<Summary> summaries = summaries_of(experiment, cells, results);
    std::vector<Section> sections{
        {"Overview", {overview_table(experiment, summaries)}, {how_to_read(experiment), power_note(experiment)}, {}}};
    const Table paper = paper_table(experiment, summaries);
    if (!paper.empty()) {
        sections.push_back({"Beside the paper", {paper}, {how_to_read_paper(experiment)}, {}});
    }
    const Table failures = failure_table(experiment, cells, results);
    if (!failures.empty()) {
        sections.push_back({failures_heading(results), {failures}, {}, {}});
    }
    for (std::size_t metric = 0; metric < all_metrics().size(); ++metric) {
        const auto is_of = [&](const Summary& summary) { return summary.metric == metric; };
        if (std::any_of(summaries.begin(), summaries.end(), is_of)) {
            const Metric& about = all_metrics()[metric];
            sections.push_back(
                {about.name + " [" + about.unit + "]", {metric_table(experiment, summaries, metric)}, {}, {}});
        }
    }
    if (!pictures.empty()) {
        sections.push_back({"Pictures", {}, {"Of each world the run of the median seed."}, pictures});
    }
    return sections;
}

std::string markdown(const std::vector<Section>& sections, const std::string& programs) {
    std::string text = "# Results\n";
    for (const Section& section : sections) {
        text += "\n## " + section.heading + "\n";
        for (const Table& table : section.tables) {
            text += "\n" + table.markdown();
        }
        for (const std::string& note : section.notes) {
            text += note.empty() ? "" : "\n" + note + "\n";
        }
        for (const Picture& picture : section.pictures) {
            text += "\n![" + picture.title + "](" + picture.file + ")\n";
        }
    }
    return text + "\n" + programs + "\n";
}

report::Page page(const std::filesystem::path& folder, const std::vector<Section>& sections,
                  const std::string& programs) {
    report::Page page("ddtool compare", report::folder_name(folder));
    for (const Section& section : sections) {
        page.section(section.heading);
        for (const Table& table : section.tables) {
            page.table(table);
        }
        for (const std::string& note : section.notes) {
            page.text(note);
        }
        std::vector<report::Picture> pictures;
        for (const Picture& picture : section.pictures) {
            pictures.push_back(report::picture_of_file(picture.title, folder / picture.file));
        }
        page.pictures(pictures);
    }
    page.text(programs);
    return page;
}

}  // namespace

Json results_json(const Experiment& experiment, const std::vector<Cell>& cells,
                  const std::vector<CellResult>& results) {
    return {{"baseline", experiment.contestants[experiment.baseline].name()},
            {"seeds", experiment.seeds},
            {"rows", full_table(experiment, summaries_of(experiment, cells, results)).json()},
            {"paper", paper_table(experiment, summaries_of(experiment, cells, results)).json()},
            {"failures", failure_table(experiment, cells, results).json()},
            {"programs", programs_of(results)}};
}

bool write_report(const std::filesystem::path& folder, const Experiment& experiment, const std::vector<Cell>& cells,
                  const std::vector<CellResult>& results, const std::vector<Picture>& pictures) {
    const std::vector<Section> sections = sections_of(experiment, cells, results, pictures);
    const std::set<std::string> programs = programs_of(results);
    const std::string computed_by = "Computed by " + joined({programs.begin(), programs.end()}) + ".";
    write_file(folder / "results.md", markdown(sections, computed_by));
    write_file(folder / "results.csv", full_table(experiment, summaries_of(experiment, cells, results)).csv());
    write_file(folder / "results.json", results_json(experiment, cells, results).dump(2) + "\n");
    return report::write_page(folder / "report.html", [&] { return page(folder, sections, computed_by); });
}

}  // namespace ddtool::compare
