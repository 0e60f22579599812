#include "study/judge/physical_agreement.hpp"

#include <cmath>
#include <map>

#include "robot/principal_axes.hpp"
#include "scores/rank_statistics.hpp"

namespace ddtool::judge {
namespace {

using dataset::Label;
using dataset::LabelRule;
using dataset::SampleRecord;

/// The smaller eigenvalue of the information about the position if the heading is known, that is of the block xx, xy,
/// yy.
double smaller_eigenvalue(const SampleRecord& sample) {
    const auto& [xx, xy, xt, yy, yt, tt] = sample.information;
    return principal_axes(xx, xy, yy).smaller;
}

/// The samples of one kind of source, as columns.
struct PhysicalColumns {
    std::vector<double> scores;
    std::vector<double> weak_sd_m;
    std::vector<double> information;
    std::vector<double> labelled_scores;
    std::vector<bool> degenerate;

    void add(double score, const SampleRecord& sample) {
        scores.push_back(score);
        weak_sd_m.push_back(sample.weak_sd_m);
        information.push_back(smaller_eigenvalue(sample));
        const Label label = sample.label_of(LabelRule::fisher);
        if (label != Label::unknown) {
            labelled_scores.push_back(score);
            degenerate.push_back(label == Label::degenerate);
        }
    }
};

}  // namespace

std::vector<PhysicalAgreement> physical_agreement(const dataset::Dataset& data, std::span<const std::size_t> samples,
                                                  std::span<const double> scores) {
    std::map<dataset::SourceKind, PhysicalColumns> by_kind;
    for (std::size_t place = 0; place < samples.size(); ++place) {
        const SampleRecord& sample = data.sample(samples[place]);
        if (!std::isnan(sample.weak_sd_m)) {
            by_kind[data.manifest().sources[sample.source].kind].add(scores[place], sample);
        }
    }
    std::vector<PhysicalAgreement> agreements;
    for (const auto& [kind, columns] : by_kind) {
        agreements.push_back({name_of(kind), columns.scores.size(),
                              roc_auc(columns.labelled_scores, columns.degenerate),
                              rank_correlation(columns.scores, columns.weak_sd_m),
                              rank_correlation(columns.scores, columns.information)});
    }
    return agreements;
}

}  // namespace ddtool::judge
