#include "ddtool/network/shipped_model.hpp"

#include <filesystem>
#include <map>
#include <string_view>

#include "ddtool/network/load_model.hpp"
#include "system/embedded_file.hpp"
#include "system/fingerprint.hpp"

DDTOOL_EMBED_FILE(ddtool_shipped_model, DDTOOL_MODELS "/ddmodel-lite.safetensors");
DDTOOL_EMBED_FILE(ddtool_paper_model, DDTOOL_MODELS "/ddmodel-paper.safetensors");

namespace ddtool {
namespace {

std::string_view bytes_between(const char* begin, const char* end) {
    return {begin, static_cast<std::size_t>(end - begin)};
}

const std::map<std::string, std::string_view>& shipped_bytes() {
    static const std::map<std::string, std::string_view> models{
        {shipped_model_name, bytes_between(ddtool_shipped_model, ddtool_shipped_model_end)},
        {paper_model_name, bytes_between(ddtool_paper_model, ddtool_paper_model_end)}};
    return models;
}

}  // namespace

bool is_shipped(const std::string& name) { return shipped_bytes().contains(name); }

std::unique_ptr<DegreeModel> shipped_model(const std::string& name) {
    return load_model(shipped_bytes().at(name), name);
}

ImageSettings image_seen_natively(const std::string& detector) {
    const std::filesystem::path file = detector;
    const auto model = file.extension() == ".safetensors"
                           ? load_model(file)
                           : shipped_model(is_shipped(detector) ? detector : shipped_model_name);
    return model->description().image;
}

std::string shipped_model_fingerprint(const std::string& name) {
    return Fingerprint().add(shipped_bytes().at(name)).hex();
}

}  // namespace ddtool
