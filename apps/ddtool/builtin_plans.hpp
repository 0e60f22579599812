#pragma once

#include <string_view>

namespace ddtool {

// Configurations that are inside the program, so that commands which are given none work wherever it is installed. Each
// is the text of a file: JSON with comments.

inline constexpr const char* default_dataset_name = "configs/dataset/default.json";
std::string_view default_dataset_plan();

inline constexpr const char* paper_ablation_name = "configs/ablation/paper.json";
std::string_view paper_ablation_plan();

}  // namespace ddtool
