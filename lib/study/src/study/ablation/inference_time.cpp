#include "study/ablation/inference_time.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "ddtool/network/particle_renderer.hpp"
#include "network/image_file.hpp"
#include "scores/statistics.hpp"

namespace ddtool::ablation {
namespace {

using Clock = std::chrono::steady_clock;

/// the first runs of a network allocate memory and compile code, so their times do not count
constexpr std::size_t uncounted = 10;

/// A temporary file that belongs to this process and is removed at the end.
class ScratchFile {
public:
    ScratchFile()
        : path_(std::filesystem::temp_directory_path() / ("ddtool-image-" + std::to_string(::getpid()) + ".png")) {}
    ~ScratchFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Draws the image into `pixels`. If `file` is not null, the image is written to that file and read back.
void make_image(ParticleRenderer& renderer, judge::Particles swarm, const ScratchFile* file, std::span<float> pixels) {
    if (file == nullptr) {
        renderer.render(swarm, pixels);
        return;
    }
    ParticleImage image;
    renderer.render(swarm, image);
    write_image_file(file->path(), image);
    image = read_image_file(file->path(), renderer.settings().size_px);
    std::transform(image.pixels.begin(), image.pixels.end(), pixels.begin(),
                   [](std::uint8_t pixel) { return pixel == ParticleImage::marked ? 1.0F : 0.0F; });
}

}  // namespace

double inference_time_ms(DegreeModel& model, std::span<const judge::Particles> swarms, bool through_file) {
    ParticleRenderer renderer(model.description().image);
    const ScratchFile file;
    std::vector<float> pixels(renderer.settings().size_px * renderer.settings().size_px);
    std::vector<double> times_ms;
    double degree = 0.0;
    for (std::size_t run = 0; run < uncounted + swarms.size(); ++run) {
        const Clock::time_point start = Clock::now();
        make_image(renderer, swarms[run % swarms.size()], through_file ? &file : nullptr, pixels);
        model.run(pixels, std::span(&degree, 1));
        times_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
    return median(std::span(times_ms).subspan(uncounted));
}

}  // namespace ddtool::ablation
