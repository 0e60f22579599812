#include "ddtool/network/shipped_model.hpp"

#include "ddtool/network/load_model.hpp"
#include "system/embedded_file.hpp"
#include "system/fingerprint.hpp"

DDTOOL_EMBED_FILE(ddtool_shipped_model, DDTOOL_SHIPPED_MODEL);

namespace ddtool {
namespace {

std::string_view shipped_bytes() {
    return {ddtool_shipped_model, static_cast<std::size_t>(ddtool_shipped_model_end - ddtool_shipped_model)};
}

}  // namespace

std::unique_ptr<DegreeModel> shipped_model() { return load_model(shipped_bytes(), shipped_model_name); }

std::string shipped_model_fingerprint() { return Fingerprint().add(shipped_bytes()).hex(); }

}  // namespace ddtool
