#include "dataset/description.hpp"
#include "dataset/grouping.hpp"

#include <gmock/gmock.h>

#include "dataset/counts.hpp"
#include "dataset/image_files.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "network/image_file.hpp"
#include "small_dataset.hpp"
#include "temporary_folder.hpp"

namespace ddtool::dataset {
namespace {

using ddtool::test::TemporaryFolder;

/// Random samples of two scenes. Their labels agree, and except for the weight's R their R values are in the order of
/// the physical ratio.
class DescriptionTest : public ::testing::Test {
protected:
    DescriptionTest() {
        for (std::size_t index = 0; index < samples_.size(); ++index) {
            SampleRecord& record = samples_[index].record;
            record.run = index % 2;
            const auto rank = static_cast<double>(index);
            record.weak_sd_m = 1.0 + rank;
            record.odometry_sd_m = 2.0;
            record.dispersion = {rank, rank, rank, -rank};
            record.label.fill(index < 6 ? Label::not_degenerate : Label::degenerate);
        }
        Manifest manifest{"this build", Json::object(), {}, {{SourceKind::world, "drawn"}}, {}, {}};
        manifest.runs.resize(2);
        manifest.runs[0].scene = "random:office:1";
        manifest.runs[1].scene = "random:office:2";
        manifest.shards.push_back(test::write_drawn_shard(folder_ / ".", "shard-0000", samples_));
        write_manifest(folder_ / ".", manifest);
    }

    std::vector<test::DrawnSample> samples_ = test::drawn_samples(10);
    TemporaryFolder folder_;
};

TEST_F(DescriptionTest, AgreementIsWholeWhereRIsInTheOrderOfThePhysics) {
    const Json rows = agreement_table(Dataset(folder_ / ".")).json();
    ASSERT_EQ(rows.size(), 7U);
    for (const Json& row : rows) {
        if (!row.at("measure").get<std::string>().starts_with("R, ")) {
            continue;
        }
        const double sign = row.at("measure") == "R, weight" ? -1.0 : 1.0;
        EXPECT_EQ(row.at("samples"), 10);
        EXPECT_EQ(row.at("accuracy"), 1.0);
        EXPECT_EQ(row.at("AUC"), sign > 0.0 ? 1.0 : 0.0);
        EXPECT_NEAR(row.at("rank correlation").get<double>(), sign, 1e-12);
    }
}

TEST_F(DescriptionTest, EveryGroupingHasEverySampleOnce) {
    std::map<std::string, std::int64_t> samples;
    for (const Json& row : group_table(Dataset(folder_ / ".")).json()) {
        samples[row.at("by")] += row.at("samples").get<std::int64_t>();
        if (row.at("by") == "scene") {
            EXPECT_EQ(row.at("value"), "random:office");
            EXPECT_EQ(row.at("degenerate: fisher"), 0.4);
        }
    }
    EXPECT_EQ(samples.size(), groupings().size());
    for (const auto& [by, count] : samples) {
        EXPECT_EQ(count, 10) << by;
    }
}

TEST_F(DescriptionTest, ImageFilesAreTheRenderedSamplesInTheirPlaces) {
    const Dataset data(folder_ / ".");
    ThreadPool threads(2);
    write_image_files(folder_ / ".", data, {}, threads);
    ParticleRenderer renderer({});
    ParticleImage expected;
    renderer.render(data.particles(7), expected);
    const auto images = folder_ / "images";
    EXPECT_EQ(read_image_file(images / "dispersion/paper/train/degenerate/000007.png", 224), expected);
    EXPECT_EQ(read_image_file(images / "fisher/held_out/validation/degenerate/000007.png", 224), expected);
    EXPECT_FALSE(std::filesystem::exists(images / "fisher/paper"));
}

TEST(Shortages, NameTheClassAndTheEmptyPart) {
    std::vector<SampleRecord> records(3);
    records[0].label[0] = Label::degenerate;
    records[0].part[0] = {Part::train, Part::test};
    const auto lines = shortages_in(counts_of(records, {.degenerate = 2, .not_degenerate = 0}));
    EXPECT_THAT(lines, testing::Contains("label dispersion: 1 samples are degenerate, wanted 2; all are taken"));
    EXPECT_THAT(lines, testing::Contains("label dispersion, split held_out: train lacks a class"));
}

}  // namespace
}  // namespace ddtool::dataset
