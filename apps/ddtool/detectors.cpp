#include "detectors.hpp"

#include "learning/engine.hpp"
#include "native/network_detector.hpp"

namespace ddtool {

DetectorTable all_detectors() {
    DetectorTable detectors;
    detectors.add_file_kind(
        ".pt", [](const std::string& file) { return native::network_detector(learning::engine().load(file, {})); });
    return detectors;
}

}  // namespace ddtool
