#include "detectors.hpp"

#include <filesystem>

#include "ddtool/network/network_detector.hpp"
#include "ddtool/network/shipped_model.hpp"
#include "train/engine.hpp"

namespace ddtool {

DetectorTable all_detectors() {
    DetectorTable detectors;
    detectors.add_file_kind(".pt",
                            [](const std::string& file) { return network_detector(train::engine().load(file, {})); });
    return detectors;
}

ImageSettings image_seen_by(const std::string& detector) {
    const std::filesystem::path file = detector;
    return file.extension() == ".pt" ? train::engine().describe(file).image : image_seen_natively(detector);
}

}  // namespace ddtool
