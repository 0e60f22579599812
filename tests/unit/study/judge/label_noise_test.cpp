#include "study/judge/label_noise.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>

#include "ddtool/base/random.hpp"
#include "temporary_folder.hpp"

namespace ddtool::judge {
namespace {

using dataset::Label;
using dataset::LabelRule;

constexpr std::size_t runs = 5;
constexpr std::size_t moments = 200;

/// Several runs in one world, whose samples have about the same times, with the labels of the two rules.
class RepeatedRuns {
public:
    using LabelAt = std::function<bool(std::size_t run, std::size_t moment)>;

    RepeatedRuns(const LabelAt& dispersion, const LabelAt& fisher, std::uint64_t other_particles = 30) {
        const auto label = [](bool degenerate) { return degenerate ? Label::degenerate : Label::not_degenerate; };
        std::vector<dataset::SampleRecord> records;
        dataset::Manifest manifest{"test", Json::object(), {}, {{dataset::SourceKind::world, "w"}}, {}, {}};
        RandomStream random({1});
        for (std::size_t run = 0; run < runs; ++run) {
            dataset::RunEntry entry;
            entry.scene = "w";
            entry.particles = run == 0 ? other_particles : 30;
            manifest.runs.push_back(entry);
            for (std::size_t moment = 0; moment < moments; ++moment) {
                dataset::SampleRecord record;
                record.run = static_cast<std::uint32_t>(run);
                record.stamp_ns = static_cast<std::int64_t>(1000 * moment + random.index(400));
                record.label = {label(dispersion(run, moment)), label(fisher(run, moment))};
                records.push_back(record);
            }
        }
        manifest.shards.push_back(dataset::write_shard(
            root_, "shard-0000", records, [](std::size_t) { return std::span<const SnapshotParticle>(); }));
        dataset::write_manifest(root_, manifest);
        data_.emplace(root_);
    }

    [[nodiscard]] const dataset::Dataset& data() const { return *data_; }

private:
    ddtool::test::TemporaryFolder folder_;
    std::filesystem::path root_ = folder_ / ".";
    std::optional<dataset::Dataset> data_;
};

bool of_place(std::size_t /*run*/, std::size_t moment) { return moment / 10 % 2 == 0; }

bool by_chance(std::size_t run, std::size_t moment) { return RandomStream({run, moment}).index(2) == 0; }

LabelNoise noise_of(const RepeatedRuns& repeated, LabelRule rule) {
    return label_noise(repeated_labels(repeated.data(), rule));
}

TEST(LabelNoise, IsNoneWhereThePlaceDecidesAndHalfWhereChanceDoes) {
    const RepeatedRuns repeated(by_chance, of_place);
    const LabelNoise fisher = noise_of(repeated, LabelRule::fisher);
    EXPECT_EQ(fisher.samples[0] + fisher.samples[1], runs * moments);
    EXPECT_EQ(fisher.balanced_disagreement, 0.0);
    EXPECT_EQ(fisher.majority_accuracy, 1.0);
    const LabelNoise dispersion = noise_of(repeated, LabelRule::dispersion);
    EXPECT_NEAR(dispersion.balanced_disagreement, 0.5, 0.05);
    EXPECT_NEAR(dispersion.majority_accuracy, 0.5, 0.08);
}

TEST(LabelNoise, OneRunThatAlwaysSaysOtherwiseDisagreesWithAll) {
    const RepeatedRuns repeated(
        of_place, [](std::size_t run, std::size_t moment) { return of_place(run, moment) != (run == 2); });
    const LabelNoise noise = noise_of(repeated, LabelRule::fisher);
    // Of the 20 ordered pairs of different runs, 8 contain the run whose labels differ. The majority of the others is
    // wrong for this run only.
    EXPECT_NEAR(noise.balanced_disagreement, 8.0 / 20.0, 1e-9);
    EXPECT_NEAR(noise.majority_accuracy, 4.0 / 5.0, 1e-9);
}

TEST(LabelNoise, ComparesRunsOfTheSameSettingsAlone) {
    const RepeatedRuns repeated(
        of_place, [](std::size_t run, std::size_t) { return run == 0; }, 60);
    const auto labels = repeated_labels(repeated.data(), LabelRule::fisher);
    EXPECT_EQ(labels.size(), (runs - 1) * moments);
    EXPECT_TRUE(std::none_of(labels.begin(), labels.end(), [](const RepeatedLabel& label) {
        return label.degenerate || label.others_degenerate > 0 || label.others != runs - 2;
    }));
    EXPECT_TRUE(std::isnan(label_noise(labels).majority_accuracy));
}

TEST(LabelNoiseTable, HasBothRulesBySceneAndInAll) {
    const Json rows = label_noise_table(RepeatedRuns(by_chance, of_place).data()).json();
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[1].at("label"), "dispersion");
    EXPECT_EQ(rows[1].at("scene"), "all");
    EXPECT_EQ(rows[2].at("majority accuracy"), 1.0);
}

}  // namespace
}  // namespace ddtool::judge
