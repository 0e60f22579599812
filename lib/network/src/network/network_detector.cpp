#include "ddtool/network/network_detector.hpp"

#include <vector>

#include "ddtool/network/particle_renderer.hpp"

namespace ddtool {
namespace {

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
        return degeneracy;
    };
}

}  // namespace ddtool
