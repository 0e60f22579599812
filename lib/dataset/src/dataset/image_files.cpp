#include "dataset/image_files.hpp"

#include <atomic>
#include <cstdio>

#include "ddtool/network/particle_renderer.hpp"
#include "network/image_file.hpp"
#include "system/folder.hpp"
#include "system/progress.hpp"

namespace ddtool::dataset {
namespace {

std::string file_name(std::size_t index) {
    char text[32];
    std::snprintf(text, sizeof text, "%06zu.png", index);
    return text;
}

/// The folder for the images of one class in one part.
std::filesystem::path class_folder(const std::filesystem::path& images, LabelRule rule, Split split, Part part,
                                   Label label) {
    return images / label_rule_names[index_of(rule)] / split_names[index_of(split)] / part_names[index_of(part)] /
           class_names[index_of(label)];
}

/// Calls visit(folder) for each folder in which the sample's image belongs.
void for_each_place(const std::filesystem::path& images, const SampleRecord& sample, const auto& visit) {
    for (const LabelRule rule : all_label_rules) {
        for (const Split split : all_splits) {
            if (const Part part = sample.part_of(rule, split); part != Part::unused) {
                visit(class_folder(images, rule, split, part, sample.label_of(rule)));
            }
        }
    }
}

}  // namespace

void write_image_files(const std::filesystem::path& folder, const Dataset& data, const ImageSettings& settings,
                       ThreadPool& threads) {
    const std::filesystem::path images = folder / images_name;
    std::filesystem::remove_all(images);
    for (std::size_t index = 0; index < data.size(); ++index) {
        for_each_place(images, data.sample(index), [](const std::filesystem::path& place) { made_folder(place); });
    }
    std::vector<ParticleRenderer> renderers(threads.size(), ParticleRenderer(settings));
    Progress progress("images", "samples");
    std::atomic<std::size_t> done = 0;
    threads.for_each(data.size(), [&](std::size_t index, std::size_t worker) {
        ParticleImage image;
        renderers[worker].render(data.particles(index), image);
        for_each_place(images, data.sample(index),
                       [&](const std::filesystem::path& place) { write_image_file(place / file_name(index), image); });
        const std::size_t count = ++done;
        if (worker == 0) {
            progress.update(static_cast<double>(count) / static_cast<double>(data.size()), count);
        }
    });
}

}  // namespace ddtool::dataset
