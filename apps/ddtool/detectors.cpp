#include "detectors.hpp"

#include <filesystem>

#include "ddtool/network/load_model.hpp"
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
    if (file.extension() == ".pt") {
        return train::engine().describe(file).image;
    }
    const auto model = file.extension() == ".safetensors"
                           ? load_model(file)
                           : shipped_model(is_shipped(detector) ? detector : shipped_model_name);
    return model->description().image;
}

}  // namespace ddtool
