#include "study/judge/model_scorer.hpp"

#include <algorithm>

#include "dataset/sample_record.hpp"
#include "ddtool/network/particle_renderer.hpp"

namespace ddtool::judge {
namespace {

/// The network, the renderer of its input, and the memory of one batch of images.
class ModelScorer {
public:
    explicit ModelScorer(std::shared_ptr<DegreeModel> model)
        : model_(std::move(model)), renderer_(model_->description().image) {}

    std::vector<double> operator()(std::span<const Particles> swarms) {
        std::vector<double> degrees(swarms.size());
        for (std::size_t first = 0; first < swarms.size(); first += most_images) {
            const std::size_t count = std::min(most_images, swarms.size() - first);
            score(swarms.subspan(first, count), std::span(degrees).subspan(first, count));
        }
        return degrees;
    }

private:
    static constexpr std::size_t most_images = 32;  // larger batches make no network faster, but take more memory

    void score(std::span<const Particles> swarms, std::span<double> degrees) {
        const std::size_t size_px = renderer_.settings().size_px;
        const std::size_t pixels = size_px * size_px;
        images_.resize(std::max(images_.size(), swarms.size() * pixels));
        for (std::size_t swarm = 0; swarm < swarms.size(); ++swarm) {
            renderer_.render(swarms[swarm], std::span(images_).subspan(swarm * pixels, pixels));
        }
        model_->run(std::span(images_).first(swarms.size() * pixels), degrees);
    }

    std::shared_ptr<DegreeModel> model_;
    ParticleRenderer renderer_;
    std::vector<float> images_;
};

/// The network's name, for example "ddmodel", followed by every setting that differs from the usual one.
std::string name_of(const ModelDescription& description) {
    std::string name = description.network;
    name += description.loss == "bce" ? ", bce" : "";
    name += description.image.linear_mapping ? "" : ", no mapping";
    name += description.image.gaussian_augmentation ? "" : ", no augmentation";
    return name;
}

std::string family_of(ModelDescription description) {
    description.seed = 0;
    description.metrics = Json();
    description.temperature = 1.0;
    return Json(description).dump();
}

}  // namespace

SwarmScorer scorer_of(std::shared_ptr<DegreeModel> model) {
    const auto scorer = std::make_shared<ModelScorer>(std::move(model));
    return [scorer](std::span<const Particles> swarms) { return (*scorer)(swarms); };
}

Detector detector_of(const std::shared_ptr<DegreeModel>& model) {
    const ModelDescription& description = model->description();
    Detector detector;
    detector.name = name_of(description);
    detector.swarm = swarm_names[dataset::index_of(description.image.swarm)];
    detector.label = description.label;
    detector.split = description.split;
    detector.seed = description.seed;
    detector.family = family_of(description);
    detector.decision = "above 0.5";
    detector.score = scorer_of(model);
    detector.is_degree = true;
    detector.image = description.image;
    return detector;
}

}  // namespace ddtool::judge
