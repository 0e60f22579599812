#include "dataset_report.hpp"

#include <array>
#include <iostream>

#include "dataset/counts.hpp"
#include "dataset/description.hpp"
#include "dataset/pictures.hpp"
#include "report/page.hpp"
#include "system/log.hpp"

namespace ddtool {
namespace {

std::vector<std::string> warnings_of(const dataset::Manifest& manifest) {
    std::vector<std::string> warnings = dataset::shortages_in(manifest.counts);
    for (const dataset::RunEntry& run : manifest.runs) {
        const std::string name = manifest.sources[run.source].name + ", seed " + std::to_string(run.seed) + ": ";
        if (!run.failure.empty()) {
            warnings.push_back(name + "failed: " + run.failure);
        }
        if (run.log_problems > 0) {
            warnings.push_back(name + "problems in the log: " + std::to_string(run.log_problems));
        }
    }
    return warnings;
}

std::vector<report::Picture> histograms_in(const std::filesystem::path& pictures) {
    return {report::picture_of_file("What the label dispersion looks at: R", pictures / "dispersion.png"),
            report::picture_of_file("What the label fisher looks at: the physical ratio", pictures / "fisher.png")};
}

std::vector<report::Picture> montages_in(const std::filesystem::path& pictures) {
    std::vector<report::Picture> montages;
    for (const dataset::LabelRule rule : {dataset::LabelRule::fisher, dataset::LabelRule::dispersion}) {
        for (const Swarm swarm : {Swarm::response, Swarm::step, Swarm::absolute}) {
            const std::string title = std::string("Label ") + dataset::label_rule_names[dataset::index_of(rule)] +
                                      ", image " + swarm_names[dataset::index_of(swarm)];
            montages.push_back(report::picture_of_file(title, pictures / dataset::montage_name(rule, swarm)));
        }
    }
    return montages;
}

report::Page dataset_page(const std::filesystem::path& folder, const std::filesystem::path& pictures,
                          const dataset::Dataset& data) {
    const dataset::Manifest& manifest = data.manifest();
    const std::array facts{report::Fact{"samples", std::to_string(data.size())},
                           report::Fact{"runs", std::to_string(manifest.runs.size())},
                           report::Fact{"sources", std::to_string(manifest.sources.size())}};
    report::Page page("ddtool build-dataset", report::folder_name(folder));
    page.warnings(warnings_of(manifest)).facts(facts);
    page.section("Samples by class and part").table(dataset::class_table(manifest.counts));
    page.section("Samples by group").table(dataset::group_table(data));
    page.section("What tells the physics").table(dataset::agreement_table(data));
    page.section("What the labels look at").pictures(histograms_in(pictures));
    page.section("Samples as a network sees them").pictures(montages_in(pictures));
    page.section("Settings").text("Made by " + manifest.program + ".").values("Settings", manifest.settings);
    return page;
}

}  // namespace

void print_dataset(const dataset::Dataset& data, bool as_json) {
    if (as_json) {
        std::cout << dataset::description_json(data).dump(2) << '\n';
        return;
    }
    std::cout << data.size() << " samples of " << data.manifest().runs.size() << " runs\n\n"
              << dataset::class_table(data.manifest().counts).text() << '\n'
              << dataset::group_table(data).text() << '\n'
              << dataset::agreement_table(data).text();
}

void draw_dataset(const std::filesystem::path& folder, const dataset::Dataset& data, const ImageSettings& settings) {
    dataset::draw_histograms(folder, data);
    dataset::draw_montages(folder, data, settings);
    log_info("pictures in " + folder.string());
}

bool write_dataset_page(const std::filesystem::path& folder, const std::filesystem::path& pictures,
                        const dataset::Dataset& data) {
    return report::write_page(folder / "report.html", [&] { return dataset_page(folder, pictures, data); });
}

}  // namespace ddtool
