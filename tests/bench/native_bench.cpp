#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "dd_weights.hpp"
#include "ddtool/network/load_model.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "swarms.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

void write_model(const std::filesystem::path& path, const std::string& network) {
    network::write_safetensors(path, test::drawn_dd_model(network, 224));
}

/// Measures the loading of a network, which a command does once at its start.
void load(benchmark::State& state, const std::string& network) {
    const test::TemporaryFolder folder;
    write_model(folder / "model.safetensors", network);
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(load_model(folder / "model.safetensors"));
    }
}
BENCHMARK_CAPTURE(load, ddmodel_lite, "ddmodel-lite")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(load, ddmodel, "ddmodel")->Unit(benchmark::kMillisecond);

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Measures the way from a snapshot of 30 particles to the degree, including the drawing of the image. The weights are
/// random, which does not change the time.
void snapshot_to_degree(benchmark::State& state, const std::string& network) {
    const std::vector<SnapshotParticle> swarm = test::normal_swarm(30, 1, {2.0, 0.5}, 2.0);
    const test::TemporaryFolder folder;
    write_model(folder / "model.safetensors", network);
    const auto model = load_model(folder / "model.safetensors");
    ParticleRenderer renderer(model->description().image);
    std::vector<float> image(renderer.settings().size_px * renderer.settings().size_px);
    std::vector<double> degree(1);
    std::vector<double> durations_us;
    for ([[maybe_unused]] auto _ : state) {
        const auto start = std::chrono::steady_clock::now();
        renderer.render(swarm, std::span<float>(image));
        model->run(image, degree);
        benchmark::DoNotOptimize(degree.data());
        durations_us.push_back(
            std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
    }
    state.counters["p50_us"] = median(durations_us);
}
BENCHMARK_CAPTURE(snapshot_to_degree, ddmodel_lite, "ddmodel-lite")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(snapshot_to_degree, ddmodel, "ddmodel")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace ddtool
