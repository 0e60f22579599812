#pragma once

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "dataset/manifest.hpp"
#include "ddtool/base/random.hpp"

namespace ddtool::dataset::test {

/// A sample all of whose values are drawn at random.
struct DrawnSample {
    SampleRecord record;
    std::vector<SnapshotParticle> particles;
};

inline DrawnSample drawn_sample(std::uint64_t seed) {
    RandomStream random({seed});
    DrawnSample sample;
    sample.record.stamp_ns = static_cast<std::int64_t>(random.index(1U << 30U));
    sample.record.update = seed;
    sample.record.odometry_motion = {random.normal(), random.normal(), random.normal()};
    sample.record.weak_sd_m = random.uniform();
    sample.record.true_pose = {std::nan(""), 0.0, 0.0};
    sample.record.label = {Label::degenerate, Label::unknown};
    sample.record.part = {{{Part::train, Part::test}, {Part::unused, Part::validation}}};
    for (std::uint64_t i = 0; i < 1 + random.index(5); ++i) {
        sample.particles.push_back({{random.normal(), random.normal(), random.normal()},
                                    {random.normal(), random.normal(), random.normal()},
                                    {random.normal(), random.normal(), random.normal()},
                                    -random.uniform(),
                                    random.normal(),
                                    random.uniform(),
                                    random.uniform()});
    }
    sample.record.particle_count = static_cast<std::uint32_t>(sample.particles.size());
    return sample;
}

inline std::vector<DrawnSample> drawn_samples(std::uint64_t count) {
    std::vector<DrawnSample> samples;
    samples.reserve(count);
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        samples.push_back(drawn_sample(seed));
    }
    return samples;
}

inline ShardEntry write_drawn_shard(const std::filesystem::path& folder, const std::string& stem,
                                    const std::vector<DrawnSample>& samples) {
    std::vector<SampleRecord> records;
    records.reserve(samples.size());
    for (const DrawnSample& sample : samples) {
        records.push_back(sample.record);
    }
    return write_shard(folder, stem, records,
                       [&](std::size_t index) { return std::span<const SnapshotParticle>(samples[index].particles); });
}

}  // namespace ddtool::dataset::test
