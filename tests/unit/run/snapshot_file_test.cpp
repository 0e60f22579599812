#include "run/snapshot_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "logs/messages/ros_conversions.hpp"
#include "small_run.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

void expect_same(const SnapshotParticle& a, const SnapshotParticle& b) {
    EXPECT_EQ(a.pose, b.pose);
    EXPECT_EQ(a.matched_motion, b.matched_motion);
    EXPECT_EQ(a.predicted_motion, b.predicted_motion);
    EXPECT_EQ(a.log_likelihood, b.log_likelihood);
    EXPECT_EQ(a.log_likelihood_increment, b.log_likelihood_increment);
    EXPECT_EQ(a.match_score, b.match_score);
    EXPECT_EQ(a.weight, b.weight);
}

void expect_same(const RecordedSnapshot& a, const RecordedSnapshot& b) {
    EXPECT_EQ(a.snapshot.stamp_ns, b.snapshot.stamp_ns);
    EXPECT_EQ(a.snapshot.update, b.snapshot.update);
    EXPECT_EQ(a.snapshot.odometry_motion, b.snapshot.odometry_motion);
    EXPECT_EQ(a.degeneracy.degree, b.degeneracy.degree);
    ASSERT_EQ(a.snapshot.particles.size(), b.snapshot.particles.size());
    for (std::size_t i = 0; i < a.snapshot.particles.size(); ++i) {
        expect_same(a.snapshot.particles[i], b.snapshot.particles[i]);
    }
}

std::vector<RecordedSnapshot> read_all(const std::filesystem::path& file, std::size_t expected_problems = 0) {
    std::size_t problems = 0;
    std::vector<RecordedSnapshot> all;
    SnapshotReader reader(file, [&](const LogProblem&) { ++problems; });
    while (auto recorded = reader.next()) {
        all.push_back(std::move(*recorded));
    }
    EXPECT_EQ(problems, expected_problems);
    return all;
}

/// Every snapshot of a run, which is also written to a file.
std::vector<RecordedSnapshot> record(const std::filesystem::path& file) {
    std::vector<RecordedSnapshot> given;
    SnapshotWriter writer(file);
    test::SmallRun small;
    small.run([&](const SensorFrame&, const std::optional<Update>& update) {
        if (update) {
            given.push_back({update->matched, {update->degeneracy.degree + 0.125}});
            writer.write(given.back().snapshot, given.back().degeneracy);
        }
        return true;
    });
    writer.close();
    return given;
}

TEST(SnapshotFile, GivesBackEveryBitOfARun) {
    const test::TemporaryFolder folder;
    const std::vector<RecordedSnapshot> given = record(folder / "snapshots.mcap");
    const std::vector<RecordedSnapshot> read = read_all(folder / "snapshots.mcap");
    ASSERT_GT(given.size(), 10U);
    ASSERT_EQ(read.size(), given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
        expect_same(read[i], given[i]);
    }
}

TEST(SnapshotFile, MayBeEmptyAndHoldEmptySwarms) {
    const test::TemporaryFolder folder;
    SnapshotWriter(folder / "none.mcap").close();
    EXPECT_TRUE(read_all(folder / "none.mcap").empty());
    SnapshotWriter writer(folder / "one.mcap");
    writer.write({7, 3, {}, {}}, {1.0});
    writer.close();
    const std::vector<RecordedSnapshot> read = read_all(folder / "one.mcap");
    ASSERT_EQ(read.size(), 1U);
    expect_same(read[0], {{7, 3, {}, {}}, {1.0}});
}

TEST(SnapshotFile, CutOffGivesWhatIsBeforeTheCut) {
    const test::TemporaryFolder folder;
    const std::size_t whole = record(folder / "snapshots.mcap").size();
    const std::string bytes = read_file(folder / "snapshots.mcap");
    write_file(folder / "cut.mcap", bytes.substr(0, bytes.size() - 1));
    EXPECT_EQ(read_all(folder / "cut.mcap", 1).size(), whole);
}

/// The layout is that of docs/formats/snapshots.md.
TEST(SnapshotFile, HasTheFlatLayoutOfItsDocument) {
    const test::TemporaryFolder folder;
    const std::vector<RecordedSnapshot> given = record(folder / "snapshots.mcap");
    McapReader reader(folder / "snapshots.mcap", {});
    for (const auto& [snapshot, degeneracy] : given) {
        const auto message = reader.next();
        ASSERT_TRUE(message.has_value());
        ASSERT_EQ(message->data.size(), 60 + 104 * snapshot.particles.size());
        const auto number_at = [&](std::size_t offset) {
            double number = 0.0;
            std::memcpy(&number, message->data.data() + offset, sizeof number);
            return number;
        };
        EXPECT_EQ(number_at(20), snapshot.odometry_motion.x_m);
        EXPECT_EQ(number_at(44), degeneracy.degree);
        EXPECT_EQ(number_at(60), snapshot.particles.front().pose.x_m);
        EXPECT_EQ(number_at(message->data.size() - 8), snapshot.particles.back().weight);
    }
}

TEST(SnapshotFile, OfAnotherKindIsRefused) {
    const test::TemporaryFolder folder;
    Ros2Writer writer(folder / "log.mcap");
    writer.write("/odom", 0, odometry_message(0, "odom", "base_link", {}));
    writer.close();
    EXPECT_THAT(test::thrown_text([&] { read_all(folder / "log.mcap"); }),
                testing::AllOf(testing::HasSubstr("log.mcap"), testing::HasSubstr("/odom"),
                               testing::HasSubstr("ddtool_msgs/msg/ParticleSnapshot")));
}

}  // namespace
}  // namespace ddtool
