#include "study/judge/groups.hpp"

namespace ddtool::detection {

Groups grouped(const dataset::Dataset& data, const LabelledSamples& samples, const dataset::Grouping& grouping) {
    Groups groups;
    for (std::size_t place = 0; place < samples.indices.size(); ++place) {
        const dataset::SampleRecord& sample = data.sample(samples.indices[place]);
        groups[grouping.key(sample, data.run_of(sample))].push_back(place);
    }
    return groups;
}

}  // namespace ddtool::detection
