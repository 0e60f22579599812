#include "dataset_report.hpp"

#include <iostream>

#include "base/log.hpp"
#include "dataset/description.hpp"
#include "dataset/histograms.hpp"
#include "dataset/montages.hpp"

namespace ddtool {

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

}  // namespace ddtool
