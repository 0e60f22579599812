#include "dataset/shard.hpp"

#include <array>
#include <cstdio>
#include <numeric>
#include <ostream>

#include "ddtool/base/error.hpp"
#include "ddtool/system/json_struct.hpp"
#include "system/crc.hpp"

namespace ddtool::dataset {

DDTOOL_JSON_STRUCT(ShardFile, file, rows, bytes, crc32)

namespace {

std::string checksum(std::span<const std::byte> bytes) {
    std::array<char, 9> text{};
    std::snprintf(text.data(), text.size(), "%08x", crc32_of(bytes));
    return text.data();
}

template <typename Row>
void put(std::ostream& out, std::span<const Row> rows) {
    const std::span<const char> bytes = bytes_of(rows);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

ShardFile write_rows(const std::filesystem::path& folder, const std::string& file, const NpyFormat& format,
                     std::size_t rows, const std::function<void(std::ostream&)>& write) {
    write_npy(folder / file, format, rows, write);
    const MappedFile written(folder / file);
    return {file, rows, written.bytes().size(), checksum(written.bytes())};
}

/// Checks that a manifest names only files in its own folder. A manifest comes with the data, and the data may come
/// from anyone.
void expect_beside(const std::filesystem::path& folder, const std::string& name) {
    if (name.empty() || name == ".." || std::filesystem::path(name).filename() != name) {
        throw Error(folder.string() + ": its list of shards names '" + name + "'; expected a file of this folder");
    }
}

template <typename Row>
MappedNpy<Row> checked(const std::filesystem::path& folder, const ShardFile& entry, const NpyFormat& format,
                       Check check) {
    expect_beside(folder, entry.file);
    const std::filesystem::path path = folder / entry.file;
    MappedNpy<Row> map(path, format);
    if (map.rows().size() != entry.rows) {
        throw Error(path.string() + ": " + std::to_string(map.rows().size()) + " rows, expected " +
                    std::to_string(entry.rows));
    }
    if (check == Check::checksums && checksum(map.file().bytes()) != entry.crc32) {
        throw Error(path.string() + ": damaged: its CRC-32 is not " + entry.crc32);
    }
    return map;
}

}  // namespace

void to_json(Json& json, const ShardEntry& entry) {
    json = {{"samples", entry.samples}, {"particles", entry.particles}};
}

void from_json(const Json& json, ShardEntry& entry) {
    entry = {json.at("samples").get<ShardFile>(), json.at("particles").get<ShardFile>()};
}

ShardEntry write_shard(const std::filesystem::path& folder, const std::string& stem, std::vector<SampleRecord> records,
                       const ParticlesOf& particles_of) {
    std::uint64_t particles = 0;
    for (SampleRecord& record : records) {
        record.first_particle = particles;
        particles += record.particle_count;
    }
    ShardEntry entry;
    entry.particles =
        write_rows(folder, stem + ".particles.npy", particles_format(), particles, [&](std::ostream& out) {
            for (std::size_t index = 0; index < records.size(); ++index) {
                put(out, particles_of(index));
            }
        });
    entry.samples = write_rows(folder, stem + ".samples.npy", samples_format(), records.size(),
                               [&](std::ostream& out) { put(out, std::span<const SampleRecord>(records)); });
    return entry;
}

MappedShard::MappedShard(const std::filesystem::path& folder, const ShardEntry& entry, Check check)
    : samples_(checked<SampleRecord>(folder, entry.samples, samples_format(), check)),
      particles_(checked<SnapshotParticle>(folder, entry.particles, particles_format(), check)) {
    for (const SampleRecord& sample : samples()) {
        if (sample.first_particle > particles_.rows().size() ||
            sample.particle_count > particles_.rows().size() - sample.first_particle) {
            throw Error((folder / entry.samples.file).string() + ": damaged: a sample's particles are not in " +
                        entry.particles.file);
        }
    }
}

}  // namespace ddtool::dataset
