#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "dataset/manifest.hpp"
#include "dataset/sample_record.hpp"

namespace ddtool::dataset {

/// A group of samples by its name; names of numbers sort like the numbers.
struct GroupKey {
    double number = 0.0;
    std::string text;
    bool operator<(const GroupKey& other) const { return std::tie(number, text) < std::tie(other.number, other.text); }
};

/// A way to part samples into groups.
struct Grouping {
    const char* name;
    GroupKey (*key)(const SampleRecord&, const RunEntry&);
};

/// By family of scenes, lidar, odometry, method, update distance and particles.
const std::vector<Grouping>& groupings();

/// The scene's name; all drawn worlds of a kind are one family, such as random:office.
std::string scene_family(const RunEntry& run);

}  // namespace ddtool::dataset
