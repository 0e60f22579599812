#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "dataset/sample_record.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::dataset {

/// A file of a data set, as the manifest describes it.
struct ShardFile {
    std::string file;  ///< in the folder of the manifest
    std::uint64_t rows = 0;
    std::uint64_t bytes = 0;
    std::string crc32;  ///< of the whole file, 8 hexadecimal digits
};

/// The file of the samples and the file of their particles.
struct ShardEntry {
    ShardFile samples;
    ShardFile particles;
};

void to_json(Json& json, const ShardEntry& entry);
void from_json(const Json& json, ShardEntry& entry);

/// How thoroughly a reader checks the files. Checking sizes costs nothing; checking checksums reads every byte once.
enum class Check { sizes, checksums };

/// Returns the swarm of the sample at that position.
using ParticlesOf = std::function<std::span<const SnapshotParticle>(std::size_t index)>;

/// Writes STEM.samples.npy and STEM.particles.npy; sets first_particle of each record. Throws Error.
ShardEntry write_shard(const std::filesystem::path& folder, const std::string& stem, std::vector<SampleRecord> records,
                       const ParticlesOf& particles_of);

/// A shard that is mapped into memory: the system reads the pages that are used, and nothing is copied.
class MappedShard {
public:
    /// Throws Error naming the file that is missing or damaged.
    MappedShard(const std::filesystem::path& folder, const ShardEntry& entry, Check check);

    [[nodiscard]] std::span<const SampleRecord> samples() const { return samples_.rows(); }
    /// Those of all samples.
    [[nodiscard]] std::span<const SnapshotParticle> particles() const { return particles_.rows(); }
    [[nodiscard]] std::span<const SnapshotParticle> particles(const SampleRecord& sample) const {
        return particles_.rows().subspan(sample.first_particle, sample.particle_count);
    }

private:
    MappedNpy<SampleRecord> samples_;
    MappedNpy<SnapshotParticle> particles_;
};

}  // namespace ddtool::dataset
