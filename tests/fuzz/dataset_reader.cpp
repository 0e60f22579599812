#include <array>
#include <filesystem>

#include "base/atomic_file.hpp"
#include "input_file.hpp"
#include "known_dataset.hpp"
#include "readers.hpp"

namespace ddtool::fuzz {
namespace {

constexpr std::size_t npy_header_bytes = 128;

/// A shard's file of the input, and the manifest that fits it: otherwise its size alone would give it away.
void exchange(dataset::ShardFile& file, std::size_t row_bytes, const std::filesystem::path& folder,
              std::span<const char> content) {
    file.bytes = content.size();
    file.rows = content.size() < npy_header_bytes ? 0 : (content.size() - npy_header_bytes) / row_bytes;
    std::ofstream(folder / file.file, std::ios::binary | std::ios::trunc)
        .write(content.data(), static_cast<std::streamsize>(content.size()));
}

void use(const dataset::Dataset& data) {
    for (std::size_t index = 0; index < data.size(); ++index) {
        (void)data.run_of(data.sample(index)).scene.size();
        double sum = 0.0;
        for (const SnapshotParticle& particle : data.particles(index)) {
            sum += particle.weight;
        }
        (void)sum;
    }
    for (const dataset::Part part : {dataset::Part::train, dataset::Part::test}) {
        (void)data.part(dataset::LabelRule::fisher, dataset::Split::held_out, part);
    }
}

}  // namespace

/// The first byte says which file of an otherwise good data set the others are.
void read_dataset(std::span<const char> content) {
    if (content.empty()) {
        return;
    }
    static const test::KnownDataset known;
    static const test::TemporaryFolder temporary;
    const std::filesystem::path folder = temporary / "data";
    std::filesystem::copy(known.folder(), folder,
                          std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
    const std::span<const char> file = content.subspan(1);
    const int choice = static_cast<unsigned char>(content.front()) % 3;
    if (choice == 0) {
        write_file(folder / dataset::manifest_name, {file.begin(), file.end()});
    } else {
        dataset::Manifest manifest = dataset::read_manifest(known.folder());
        dataset::ShardEntry& shard = manifest.shards.front();
        choice == 1 ? exchange(shard.samples, sizeof(dataset::SampleRecord), folder, file)
                    : exchange(shard.particles, sizeof(SnapshotParticle), folder, file);
        dataset::write_manifest(folder, manifest);
    }
    use(dataset::Dataset(folder));
}

}  // namespace ddtool::fuzz
