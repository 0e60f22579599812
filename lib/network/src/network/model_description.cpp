#include "ddtool/network/model_description.hpp"

#include <array>

#include "ddtool/base/error.hpp"
#include "system/expect.hpp"

namespace ddtool {
namespace {

constexpr std::array<const char*, 2> loss_names{"cross-entropy", "bce"};

}  // namespace

ModelDescription parse_model_description(const std::string& text, const std::string& file) {
    try {
        auto description = parse_json(text, "JSON").get<ModelDescription>();
        expect_one_of("loss", description.loss, loss_names);
        expect_valid(description.image);
        expect_between("temperature", description.temperature, 1e-6, 1e6);
        return description;
    } catch (const std::exception& error) {
        throw Error(file + ": its description: " + error.what());
    }
}

}  // namespace ddtool
