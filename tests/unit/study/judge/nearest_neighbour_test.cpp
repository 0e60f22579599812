#include "study/judge/nearest_neighbour.hpp"

#include <gmock/gmock.h>

#include "ddtool/base/error.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool::judge {
namespace {

using dataset::Label;
using dataset::Part;

constexpr Task on_test{.label = dataset::LabelRule::dispersion, .split = dataset::Split::paper};
constexpr std::size_t moments_of_run = 12;

/// Particles in a row of that length, whose images differ the more the lengths do.
std::vector<SnapshotParticle> row_of(double length_m) {
    constexpr double step_m = 0.05;
    std::vector<SnapshotParticle> swarm(static_cast<std::size_t>(length_m / step_m) + 1);
    for (std::size_t index = 0; index < swarm.size(); ++index) {
        swarm[index].pose.x_m = step_m * static_cast<double>(index);
    }
    return swarm;
}

/// Two runs in which narrow and wide swarms alternate. In the run 0 the wide ones are degenerate; in the run 1 the
/// narrow ones, unless the runs agree. The swarms of the run 1 are a little wider, so that the nearest image is one of
/// the same run. Every third sample is for the test.
class TwoRuns {
public:
    explicit TwoRuns(bool agree) {
        std::vector<dataset::SampleRecord> records;
        std::vector<std::vector<SnapshotParticle>> swarms;
        dataset::Manifest manifest{"test", Json::object(), {}, {{dataset::SourceKind::world, "w"}}, {{}, {}}, {}};
        for (std::uint32_t run = 0; run < 2; ++run) {
            for (std::size_t moment = 0; moment < moments_of_run; ++moment) {
                const bool wide = moment % 2 == 0;
                dataset::SampleRecord record;
                record.run = run;
                record.stamp_ns = static_cast<std::int64_t>(moment);
                record.label[0] = wide == (agree || run == 0) ? Label::degenerate : Label::not_degenerate;
                record.part[0][index_of(dataset::Split::paper)] = moment % 3 == 0 ? Part::test : Part::train;
                swarms.push_back(row_of((wide ? 4.0 : 1.0) + (run == 0 ? 0.0 : 0.5)));
                record.particle_count = static_cast<std::uint32_t>(swarms.back().size());
                records.push_back(record);
            }
        }
        manifest.shards.push_back(dataset::write_shard(root_, "shard-0000", records, [&](std::size_t sample) {
            return std::span<const SnapshotParticle>(swarms[sample]);
        }));
        dataset::write_manifest(root_, manifest);
        data_.emplace(root_);
    }

    [[nodiscard]] Json rows() const { return nearest_neighbour_table(*data_, {}, on_test).json(); }
    [[nodiscard]] const dataset::Dataset& data() const { return *data_; }

private:
    ddtool::test::TemporaryFolder folder_;
    std::filesystem::path root_ = folder_ / ".";
    std::optional<dataset::Dataset> data_;
};

TEST(NearestNeighbour, RemembersItsRunAndIsWrongWithoutItWhereRunsContradict) {
    const Json rows = TwoRuns(false).rows();
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[0].at("samples"), 8);
    EXPECT_EQ(rows[0].at("accuracy"), 1.0);
    EXPECT_EQ(rows[1].at("samples"), 8);
    EXPECT_EQ(rows[1].at("accuracy"), 0.0);
    EXPECT_EQ(rows[1].at("swarm"), "absolute");
}

TEST(NearestNeighbour, IsRightWithoutItsRunWhereRunsAgree) {
    const Json rows = TwoRuns(true).rows();
    EXPECT_EQ(rows[0].at("accuracy"), 1.0);
    EXPECT_EQ(rows[1].at("accuracy"), 1.0);
}

TEST(NearestNeighbour, TheSampleBeforeIsTheOneBeforeInTheSameRun) {
    const Json rows = TwoRuns(true).rows();
    EXPECT_EQ(rows[2].at("samples"), 2 * (moments_of_run - 1));
    EXPECT_EQ(rows[2].at("accuracy"), 0.0) << "narrow and wide alternate";
    EXPECT_EQ(rows[3].at("accuracy"), 0.5);
}

TEST(NearestNeighbour, NeedsSamplesToRemember) {
    const TwoRuns runs(true);
    EXPECT_THAT(ddtool::test::thrown_text<Error>([&] { (void)nearest_neighbour_table(runs.data(), {}, Task{}); }),
                testing::HasSubstr("fisher / held_out / test"));
}

}  // namespace
}  // namespace ddtool::judge
