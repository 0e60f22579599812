#include "study/judge/samples.hpp"

#include <algorithm>

#include "system/progress.hpp"

namespace ddtool::judge {

LabelledSamples labelled_samples(const dataset::Dataset& data, dataset::LabelRule label, dataset::Split split,
                                 dataset::Part part) {
    LabelledSamples samples{data.part(label, split, part), {}};
    for (const std::size_t index : samples.indices) {
        samples.degenerate.push_back(data.sample(index).label_of(label) == dataset::Label::degenerate);
    }
    return samples;
}

Groups grouped(const dataset::Dataset& data, const LabelledSamples& samples, const dataset::Grouping& grouping) {
    Groups groups;
    for (std::size_t place = 0; place < samples.indices.size(); ++place) {
        const dataset::SampleRecord& sample = data.sample(samples.indices[place]);
        groups[grouping.key(sample, data.run_of(sample))].push_back(place);
    }
    return groups;
}

std::vector<double> scores_of(const dataset::Dataset& data, const std::vector<std::size_t>& samples,
                              const SwarmScorer& scorer, const std::string& what) {
    constexpr std::size_t piece = 256;  // number of swarms that are scored between two updates of the progress display
    Progress progress(what, "samples");
    std::vector<double> scores;
    std::vector<Particles> swarms;
    while (scores.size() < samples.size()) {
        swarms.clear();
        const std::size_t end = std::min(samples.size(), scores.size() + piece);
        for (std::size_t place = scores.size(); place < end; ++place) {
            swarms.push_back(data.particles(samples[place]));
        }
        const std::vector<double> scored = scorer(swarms);
        scores.insert(scores.end(), scored.begin(), scored.end());
        progress.update(static_cast<double>(end) / static_cast<double>(samples.size()), end);
    }
    return scores;
}

}  // namespace ddtool::judge
