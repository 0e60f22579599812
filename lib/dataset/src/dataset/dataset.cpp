#include "dataset/dataset.hpp"

#include <algorithm>

#include "ddtool/base/error.hpp"

namespace ddtool::dataset {
namespace {

bool is_label(Label label) {
    return label == Label::unknown || label == Label::not_degenerate || label == Label::degenerate;
}

std::string fault_of(const SampleRecord& sample, const Manifest& manifest) {
    if (sample.run >= manifest.runs.size()) {
        return std::string("a sample's run is not in ") + manifest_name;
    }
    if (sample.source >= manifest.sources.size()) {
        return std::string("a sample's source is not in ") + manifest_name;
    }
    return std::ranges::all_of(sample.label, is_label) ? "" : "a sample's label is none";
}

}  // namespace

Dataset::Dataset(const std::filesystem::path& folder, Check check) : manifest_(read_manifest(folder)) {
    for (const ShardEntry& entry : manifest_.shards) {
        const auto shard = static_cast<std::uint32_t>(shards_.size());
        shards_.emplace_back(folder, entry, check);
        for (const SampleRecord& sample : shards_.back().samples()) {
            if (const std::string fault = fault_of(sample, manifest_); !fault.empty()) {
                throw Error((folder / entry.samples.file).string() + ": damaged: " + fault);
            }
            places_.push_back({shard, static_cast<std::uint32_t>(&sample - shards_.back().samples().data())});
        }
    }
}

const SampleRecord& Dataset::sample(std::size_t index) const {
    const Place& place = places_[index];
    return shards_[place.shard].samples()[place.row];
}

std::span<const SnapshotParticle> Dataset::particles(std::size_t index) const {
    return shards_[places_[index].shard].particles(sample(index));
}

std::vector<std::size_t> Dataset::part(LabelRule rule, Split split, Part part) const {
    std::vector<std::size_t> indices;
    for (std::size_t index = 0; index < size(); ++index) {
        if (sample(index).part_of(rule, split) == part) {
            indices.push_back(index);
        }
    }
    return indices;
}

}  // namespace ddtool::dataset
