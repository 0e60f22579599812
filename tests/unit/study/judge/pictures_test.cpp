#include "study/judge/pictures.hpp"

#include <gmock/gmock.h>

#include "known_dataset.hpp"
#include "study/judge/simple_rules.hpp"

namespace ddtool::judge {
namespace {

using ddtool::test::KnownDataset;

TEST(DrawEvaluations, DrawsEveryPictureAlsoWithoutThresholds) {
    const KnownDataset known(dataset::Part::test);
    const ddtool::test::TemporaryFolder folder;
    for (const auto label : {dataset::LabelRule::fisher, dataset::LabelRule::dispersion}) {
        std::vector<Evaluation> evaluations;
        for (const Detector& rule : fitted_rules(known.data(), label, dataset::Split::held_out)) {
            evaluations.push_back(evaluate(known.data(), rule, {}));
        }
        const auto into = folder / dataset::label_rule_names[index_of(label)];
        draw_evaluations(into, known.data(), evaluations, detailed(evaluations).front());
        for (const char* name : {"roc.png", "reliability.png", "confusion.png", "particles.png", "mistakes.png"}) {
            EXPECT_GT(std::filesystem::file_size(into / name), 100U) << name;
        }
    }
    // The regression is wrong on the test part, so its picture of mistakes contains more than titles.
    EXPECT_GT(std::filesystem::file_size(folder / "fisher/mistakes.png"),
              std::filesystem::file_size(folder / "dispersion/mistakes.png"));
}

}  // namespace
}  // namespace ddtool::judge
