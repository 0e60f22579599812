#include "version.hpp"

#include <fastcdr/config.h>
#include <google/protobuf/stubs/common.h>
#include <lz4.h>
#include <spdlog/version.h>
#include <zstd.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <opencv2/core/version.hpp>

#ifdef DDTOOL_WITH_TORCH
#include <torch/version.h>
#endif

#include "build_commit.hpp"

namespace ddtool {
namespace {

std::string dotted(int major, int minor, int patch) {
    return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

std::string compiler() {
#ifdef __clang__
    return "Clang " __clang_version__;
#else
    return "GCC " __VERSION__;
#endif
}

std::string torch_version() {
#ifdef DDTOOL_WITH_TORCH
    return TORCH_VERSION;
#else
    return "none (built without)";
#endif
}

}  // namespace

std::vector<Version> versions() {
    return {{"ddtool", DDTOOL_VERSION " (commit " DDTOOL_COMMIT ")"},
            {"compiler", compiler()},
            {"CLI11", CLI11_VERSION},
            {"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
            {"fast-cdr", FASTCDR_VERSION_STR},
            {"LibTorch", torch_version()},
            {"lz4", LZ4_versionString()},
            {"nlohmann-json",
             dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
            {"OpenCV", CV_VERSION},
            {"protobuf", google::protobuf::internal::VersionString(GOOGLE_PROTOBUF_VERSION)},
            {"spdlog", dotted(SPDLOG_VER_MAJOR, SPDLOG_VER_MINOR, SPDLOG_VER_PATCH)},
            {"zstd", ZSTD_versionString()}};
}

std::string program_version() { return versions().front().name + " " + versions().front().number; }

std::string version_text() {
    std::string text;
    for (const auto& [name, number] : versions()) {
        text += (text.empty() ? "" : "\n") + name + " " + number;
    }
    return text;
}

}  // namespace ddtool
