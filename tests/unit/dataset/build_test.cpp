#include <gmock/gmock.h>

#include "dataset/snapshot_run.hpp"
#include "run/snapshot_file.hpp"
#include "small_dataset.hpp"
#include "thrown_text.hpp"
#include "tiny_build.hpp"

namespace ddtool::dataset {
namespace {

using ddtool::test::TemporaryFolder;
using testing::HasSubstr;

class BuildTest : public ::testing::Test {
protected:
    /// Builds the data set again from the stored parts. A missing run would be an error.
    [[nodiscard]] Dataset relabelled(const std::string& rule, double threshold) {
        Json changed = settings_;
        changed["labels"][rule] = threshold;
        return test::merge_in(folder_ / "out", changed, {});
    }
    [[nodiscard]] static std::size_t degenerate(const Dataset& data, LabelRule rule) {
        std::size_t count = 0;
        for (std::size_t index = 0; index < data.size(); ++index) {
            count += data.sample(index).label_of(rule) == Label::degenerate ? 1U : 0U;
        }
        return count;
    }

    TemporaryFolder folder_;
    Json settings_ = test::tiny_settings(folder_);
};

TEST_F(BuildTest, AnotherThresholdNeedsNoRun) {
    settings_["balance"] = {{"degenerate", 1000U}, {"not_degenerate", 1000U}};
    const Dataset first = test::build_in(folder_ / "out", settings_);
    const Dataset all = relabelled("dispersion_threshold", 0.0);
    EXPECT_EQ(degenerate(all, LabelRule::dispersion), all.size());
    EXPECT_EQ(all.size(), first.size());
    const Dataset none = relabelled("dispersion_threshold", 1e6);
    EXPECT_EQ(degenerate(none, LabelRule::dispersion), 0U);
    EXPECT_EQ(degenerate(none, LabelRule::fisher), degenerate(first, LabelRule::fisher));
    EXPECT_EQ(degenerate(relabelled("fisher_ratio", 0.0), LabelRule::fisher), first.size());
}

TEST_F(BuildTest, SwarmsOfOtherSizesSeeTheSamePieceOfADrive) {
    settings_["thinning"] = {{"every", 1U}, {"most_per_run", 100U}};
    const auto stamps_ns = [&](std::size_t particles) {
        settings_["mix"]["particles"] = Json::array({particles});
        settings_["most_particle_updates"] = 5 * particles;
        std::vector<std::int64_t> stamps;
        for (const PlannedRun& run : plan_runs(settings_).runs) {
            for (const Sample& sample : make_run(run, [](double) {}).samples) {
                stamps.push_back(sample.record.stamp_ns);
            }
        }
        return stamps;
    };
    const std::vector<std::int64_t> by_two = stamps_ns(2);
    EXPECT_EQ(by_two.size(), 8U * 4U) << "of 5 updates each, all but the first";
    EXPECT_EQ(stamps_ns(5), by_two);
}

TEST_F(BuildTest, ARecordingWithoutInformationHasOneLabelOnly) {
    const auto drawn = test::drawn_samples(9);
    {
        SnapshotWriter writer(folder_ / "recorded.mcap");
        for (const test::DrawnSample& each : drawn) {
            const SampleRecord& record = each.record;
            writer.write({record.stamp_ns, record.update, record.odometry_motion, each.particles}, {});
        }
        writer.close();
    }
    settings_["worlds"] = Json::array();
    settings_["snapshots"] = Json::array({(folder_ / "recorded.mcap").string()});
    settings_["thinning"] = {{"every", 1U}, {"most_per_run", 100U}};
    const Dataset data = test::build_in(folder_ / "out", settings_);
    ASSERT_EQ(data.size(), drawn.size());
    for (std::size_t index = 0; index < data.size(); ++index) {
        const SampleRecord& sample = data.sample(index);
        EXPECT_EQ(sample.update, index);
        EXPECT_EQ(sample.label_of(LabelRule::fisher), Label::unknown);
        EXPECT_NE(sample.label_of(LabelRule::dispersion), Label::unknown);
        EXPECT_TRUE(std::isnan(sample.weak_sd_m));
        EXPECT_EQ(data.particles(index)[0].pose, drawn[index].particles[0].pose);
    }
    EXPECT_EQ(data.manifest().runs[0].scene, "recorded");
}

TEST_F(BuildTest, ARunThatFailsIsNamedAndTheOthersGoOn) {
    settings_["logs"] = Json::array({(folder_ / "missing.mcap").string()});
    const Dataset data = test::build_in(folder_ / "out", settings_);
    EXPECT_GT(data.size(), 10U);
    EXPECT_THAT(data.manifest().runs.back().failure, HasSubstr("missing.mcap"));
    EXPECT_EQ(data.manifest().runs.front().failure, "");
}

TEST_F(BuildTest, NoSceneIsInTwoHeldOutParts) {
    settings_ = test::tiny_settings(folder_, 6);
    settings_["balance"] = {{"degenerate", 20U}, {"not_degenerate", 20U}};
    const Dataset data = test::build_in(folder_ / "out", settings_);
    std::map<std::string, Part> part_of;
    for (std::size_t index = 0; index < data.size(); ++index) {
        const SampleRecord& sample = data.sample(index);
        for (const LabelRule rule : {LabelRule::dispersion, LabelRule::fisher}) {
            const Part part = sample.part_of(rule, Split::held_out);
            EXPECT_EQ(part == Part::unused, sample.part_of(rule, Split::paper) == Part::unused);
            if (part != Part::unused) {
                EXPECT_EQ(part_of.try_emplace(data.run_of(sample).scene, part).first->second, part);
            }
        }
    }
    EXPECT_EQ(part_of.size(), 6U);
}

}  // namespace
}  // namespace ddtool::dataset
