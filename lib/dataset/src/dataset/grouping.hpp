#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "dataset/manifest.hpp"
#include "dataset/sample_record.hpp"

namespace ddtool::dataset {

/// The name of a group of samples. Names that are numbers are sorted by value.
struct GroupKey {
    double number = 0.0;
    std::string text;
    bool operator<(const GroupKey& other) const { return std::tie(number, text) < std::tie(other.number, other.text); }
};

/// A way to divide samples into groups.
struct Grouping {
    const char* name;
    GroupKey (*key)(const SampleRecord&, const RunEntry&);
};

/// The groupings by family of scenes, lidar, odometry, method, update distance and number of particles.
const std::vector<Grouping>& groupings();

/// The name of the scene, or for a world that was drawn at random its kind, such as random:office.
std::string scene_family(const RunEntry& run);

}  // namespace ddtool::dataset
