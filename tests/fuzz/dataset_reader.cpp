#include <algorithm>
#include <array>
#include <filesystem>

#include "dataset/counts.hpp"
#include "dataset/description.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "input_file.hpp"
#include "known_dataset.hpp"
#include "readers.hpp"
#include "system/atomic_file.hpp"

namespace ddtool::fuzz {
namespace {

/// The length of the header of an .npy file of format 1.0: magic and version, the length of the text, and the text.
std::size_t header_bytes(std::span<const char> file) {
    constexpr std::size_t preamble = 10;
    const auto length = [&](std::size_t at) { return static_cast<std::size_t>(static_cast<unsigned char>(file[at])); };
    return file.size() < preamble ? file.size() : std::min(file.size(), preamble + length(8) + (length(9) << 8U));
}

/// Replaces a file of the shard by the input, and makes the manifest agree with its size. Otherwise the reader would
/// reject every input whose size differs from the manifest's.
void exchange(dataset::ShardFile& file, std::size_t row_bytes, const std::filesystem::path& folder,
              std::span<const char> content) {
    file.bytes = content.size();
    file.rows = (content.size() - header_bytes(content)) / row_bytes;
    std::ofstream(folder / file.file, std::ios::binary | std::ios::trunc)
        .write(content.data(), static_cast<std::streamsize>(content.size()));
}

/// Does with the data set what `ddtool dataset` and a training do.
void use(const dataset::Dataset& data) {
    constexpr std::size_t drawn_samples = 4;
    (void)dataset::description_json(data);
    (void)dataset::class_table(data.manifest().counts);
    (void)dataset::shortages_in(data.manifest().counts);
    ParticleImage image;
    for (const Swarm swarm : {Swarm::absolute, Swarm::step, Swarm::response}) {
        ParticleRenderer renderer({.swarm = swarm, .size_px = 16});
        for (std::size_t index = 0; index < std::min(drawn_samples, data.size()); ++index) {
            renderer.render(data.particles(index), image);
        }
    }
    for (const dataset::Part part : {dataset::Part::train, dataset::Part::test}) {
        (void)data.part(dataset::LabelRule::fisher, dataset::Split::held_out, part);
    }
}

}  // namespace

/// Replaces one file of an otherwise sound data set by the input. The first byte says which file.
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
