#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "dataset/manifest.hpp"

namespace ddtool::dataset {

/// A data set on disk (docs/formats/dataset.md), mapped into memory: opening does not read the samples, and they are
/// never copied. Safe to read from many threads.
class Dataset {
public:
    /// Sizes are always checked. Throws Error naming the file that is missing or damaged.
    explicit Dataset(const std::filesystem::path& folder, Check check = Check::sizes);

    [[nodiscard]] const Manifest& manifest() const { return manifest_; }
    /// The files, whose rows one after the other are the samples.
    [[nodiscard]] const std::vector<MappedShard>& shards() const { return shards_; }
    [[nodiscard]] std::size_t size() const { return places_.size(); }
    [[nodiscard]] const SampleRecord& sample(std::size_t index) const;
    [[nodiscard]] std::span<const SnapshotParticle> particles(std::size_t index) const;
    [[nodiscard]] const RunEntry& run_of(const SampleRecord& sample) const { return manifest_.runs[sample.run]; }
    /// Positions of the samples in a part of a split, in rising order.
    [[nodiscard]] std::vector<std::size_t> part(LabelRule rule, Split split, Part part) const;

private:
    struct Place {
        std::uint32_t shard = 0;
        std::uint32_t row = 0;
    };

    Manifest manifest_;
    std::vector<MappedShard> shards_;
    std::vector<Place> places_;
};

}  // namespace ddtool::dataset
