#include <benchmark/benchmark.h>

#include "ddtool/network/particle_renderer.hpp"
#include "network/image_file.hpp"
#include "swarms.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

/// Renders particles that are spread along a corridor. This is the slow case, because few of their pixels overlap.
void render(benchmark::State& state, const ImageSettings& settings) {
    const std::vector<SnapshotParticle> swarm =
        test::normal_swarm(static_cast<std::size_t>(state.range(0)), 1, {2.0, 0.5}, 2.0);
    ParticleRenderer renderer(settings);
    ParticleImage image;
    for ([[maybe_unused]] auto _ : state) {
        renderer.render(swarm, image);
        benchmark::DoNotOptimize(image.pixels.data());
    }
}
BENCHMARK_CAPTURE(render, absolute, ImageSettings{})->Arg(30)->Arg(1000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(render, step, ImageSettings{.swarm = Swarm::step})->Arg(30)->Arg(1000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(render, no_augmentation, ImageSettings{.gaussian_augmentation = false})
    ->Arg(30)
    ->Arg(1000)
    ->Unit(benchmark::kMicrosecond);

void render_floats(benchmark::State& state) {
    const std::vector<SnapshotParticle> swarm = test::normal_swarm(30, 1, {2.0, 0.5}, 2.0);
    ParticleRenderer renderer({});
    std::vector<float> pixels(renderer.settings().size_px * renderer.settings().size_px);
    for ([[maybe_unused]] auto _ : state) {
        renderer.render(swarm, std::span<float>(pixels));
        benchmark::DoNotOptimize(pixels.data());
    }
}
BENCHMARK(render_floats)->Unit(benchmark::kMicrosecond);

/// Measures how long an image takes to reach the network through a file, as in the paper.
void through_image_file(benchmark::State& state) {
    const test::TemporaryFolder folder;
    ParticleRenderer renderer({});
    ParticleImage image;
    renderer.render(test::normal_swarm(30, 1, {2.0, 0.5}, 2.0), image);
    for ([[maybe_unused]] auto _ : state) {
        write_image_file(folder / "swarm.png", image);
        benchmark::DoNotOptimize(read_image_file(folder / "swarm.png", image.size_px));
    }
}
BENCHMARK(through_image_file)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace ddtool
