#include "ddtool/network/network_detector.hpp"

#include <cmath>
#include <vector>

#include "ddtool/network/particle_renderer.hpp"

namespace ddtool {
namespace {

/// Degrees are rounded to thousandths. The same network run by another library answers with another last digit, 1e-7,
/// and by the pixels of later images such a difference grows to a centimetre of the path.
constexpr double degree_steps = 1000.0;

/// The network, the renderer of its input, and the memory of one image.
struct Sight {
    explicit Sight(std::shared_ptr<DegreeModel> network)
        : model(std::move(network)),
          renderer(model->description().image),
          image(renderer.settings().size_px * renderer.settings().size_px) {}

    std::shared_ptr<DegreeModel> model;
    ParticleRenderer renderer;
    std::vector<float> image;
};

}  // namespace

DegeneracyDetector network_detector(std::shared_ptr<DegreeModel> model) {
    return [sight = std::make_shared<Sight>(std::move(model))](const ParticleSnapshot& swarm) {
        Degeneracy degeneracy;
        sight->renderer.render(swarm.particles, std::span(sight->image));
        sight->model->run(sight->image, std::span(&degeneracy.degree, 1));
        degeneracy.degree = std::round(degeneracy.degree * degree_steps) / degree_steps;
        return degeneracy;
    };
}

}  // namespace ddtool
