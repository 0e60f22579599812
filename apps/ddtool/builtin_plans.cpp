#include "builtin_plans.hpp"

#include <cstddef>

#include "system/embedded_file.hpp"

DDTOOL_EMBED_FILE(ddtool_default_dataset, DDTOOL_CONFIGS "/dataset/default.json");
DDTOOL_EMBED_FILE(ddtool_paper_ablation, DDTOOL_CONFIGS "/ablation/paper.json");

namespace ddtool {

std::string_view default_dataset_plan() {
    return {ddtool_default_dataset, static_cast<std::size_t>(ddtool_default_dataset_end - ddtool_default_dataset)};
}

std::string_view paper_ablation_plan() {
    return {ddtool_paper_ablation, static_cast<std::size_t>(ddtool_paper_ablation_end - ddtool_paper_ablation)};
}

}  // namespace ddtool
