#include "study/judge/nearest_neighbour.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <map>

#include "ddtool/base/error.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "scores/confusion.hpp"
#include "study/judge/samples.hpp"
#include "system/progress.hpp"

namespace ddtool::judge {
namespace {

using dataset::Dataset;
using dataset::SampleRecord;

/// A black-and-white image, one bit for each pixel.
using Bits = std::vector<std::uint64_t>;

constexpr std::size_t word_bits = 64;

class BitRenderer {
public:
    explicit BitRenderer(const ImageSettings& settings) : renderer_(settings) {}

    Bits operator()(Particles swarm) {
        renderer_.render(swarm, image_);
        Bits bits((image_.pixels.size() + word_bits - 1) / word_bits);
        for (std::size_t pixel = 0; pixel < image_.pixels.size(); ++pixel) {
            const bool marked = image_.pixels[pixel] == ParticleImage::marked;
            bits[pixel / word_bits] |= static_cast<std::uint64_t>(marked) << (pixel % word_bits);
        }
        return bits;
    }

private:
    ParticleRenderer renderer_;
    ParticleImage image_;
};

std::size_t differing_pixels(const Bits& a, const Bits& b) {
    std::size_t count = 0;
    for (std::size_t word = 0; word < a.size(); ++word) {
        count += static_cast<std::size_t>(std::popcount(a[word] ^ b[word]));
    }
    return count;
}

/// A sample that is remembered.
struct Remembered {
    Bits image;
    std::uint32_t run = 0;
    bool degenerate = false;
};

/// The nearest of the remembered images that were looked at; of equally near ones the first.
class Nearest {
public:
    void look_at(const Remembered& other, std::size_t distance) {
        if (distance < distance_) {
            distance_ = distance;
            other_ = &other;
        }
    }
    /// Null if there was none.
    [[nodiscard]] const Remembered* found() const { return other_; }

private:
    std::size_t distance_ = std::numeric_limits<std::size_t>::max();
    const Remembered* other_ = nullptr;
};

struct Guesses {
    Confusion of_any_run;
    Confusion of_other_runs;
};

Guesses nearest_guesses(const Dataset& data, const ImageSettings& image, const LabelledSamples& train,
                        const LabelledSamples& test) {
    BitRenderer render(image);
    std::vector<Remembered> memory;
    for (std::size_t place = 0; place < train.indices.size(); ++place) {
        const std::size_t index = train.indices[place];
        memory.push_back({render(data.particles(index)), data.sample(index).run, train.degenerate[place]});
    }
    Guesses guesses;
    Progress progress("nearest neighbour", "samples");
    for (std::size_t place = 0; place < test.indices.size(); ++place) {
        const std::size_t index = test.indices[place];
        const Bits seen = render(data.particles(index));
        Nearest of_any_run;
        Nearest of_other_runs;
        for (const Remembered& other : memory) {
            const std::size_t distance = differing_pixels(seen, other.image);
            of_any_run.look_at(other, distance);
            if (other.run != data.sample(index).run) {
                of_other_runs.look_at(other, distance);
            }
        }
        guesses.of_any_run.add(of_any_run.found()->degenerate, test.degenerate[place]);
        if (of_other_runs.found() != nullptr) {
            guesses.of_other_runs.add(of_other_runs.found()->degenerate, test.degenerate[place]);
        }
        progress.update(static_cast<double>(place + 1) / static_cast<double>(test.indices.size()), place + 1);
    }
    return guesses;
}

Confusion guesses_from_before(const Dataset& data, dataset::LabelRule rule) {
    std::map<std::uint32_t, std::vector<const SampleRecord*>> runs;
    for (std::size_t index = 0; index < data.size(); ++index) {
        const SampleRecord& sample = data.sample(index);
        if (sample.label_of(rule) != dataset::Label::unknown) {
            runs[sample.run].push_back(&sample);
        }
    }
    Confusion guesses;
    for (auto& [run, samples] : runs) {
        std::ranges::sort(samples, {}, &SampleRecord::stamp_ns);
        for (std::size_t next = 1; next < samples.size(); ++next) {
            guesses.add(samples[next - 1]->label_of(rule) == dataset::Label::degenerate,
                        samples[next]->label_of(rule) == dataset::Label::degenerate);
        }
    }
    return guesses;
}

Confusion guesses_of_larger_class(const LabelledSamples& test) {
    const auto degenerate = static_cast<std::size_t>(std::ranges::count(test.degenerate, true));
    const bool guess = 2 * degenerate >= test.degenerate.size();
    Confusion guesses;
    for (const bool truth : test.degenerate) {
        guesses.add(guess, truth);
    }
    return guesses;
}

}  // namespace

Table nearest_neighbour_table(const Dataset& data, const ImageSettings& image, const Task& task) {
    const LabelledSamples train = labelled_samples(data, task.label, task.split, dataset::Part::train);
    const LabelledSamples test = labelled_samples(data, task.label, task.split, task.part);
    if (train.indices.empty() || test.indices.empty()) {
        throw Error("no samples for " + name_of(task) + ", or none in the part train to compare them with");
    }
    const Guesses nearest = nearest_guesses(data, image, train, test);
    Table table({{"guess"}, {"swarm"}, {"tested on"}, {"samples"}, {"accuracy"}, {"F1"}});
    const auto add = [&](const std::string& guess, const std::string& swarm, const std::string& tested_on,
                         const Confusion& guesses) {
        table.add_row(
            {guess, swarm, tested_on, static_cast<std::int64_t>(guesses.count()), guesses.accuracy(), guesses.f1()});
    };
    const std::string swarm = swarm_names[dataset::index_of(image.swarm)];
    const std::string label = dataset::label_rule_names[index_of(task.label)];
    add("nearest training image", swarm, name_of(task), nearest.of_any_run);
    add("nearest training image of another run", swarm, name_of(task), nearest.of_other_runs);
    add("label of the sample before", "-", label, guesses_from_before(data, task.label));
    add("always the larger class", "-", name_of(task), guesses_of_larger_class(test));
    return table;
}

}  // namespace ddtool::judge
