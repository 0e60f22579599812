#include "scores/relations.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "ddtool/base/error.hpp"
#include "wandering_path.hpp"

namespace ddtool {
namespace {

/// The true relations of a path: its own motions over `stride` poses.
std::vector<Relation> relations_of(const Trajectory& path, std::size_t stride) {
    std::vector<Relation> relations;
    for (std::size_t i = 0; i + stride < path.size(); ++i) {
        relations.push_back(
            {path[i].stamp_ns, path[i + stride].stamp_ns, between(path[i].pose, path[i + stride].pose)});
    }
    return relations;
}

TEST(Relations, OfThePathItselfHaveNoError) {
    const Trajectory path = wandering_path(40, 1);
    const RelationErrors errors = score_relations(moved(path, {1.0, 2.0, 3.0}), relations_of(path, 7));
    EXPECT_EQ(errors.all.translation_m.count, 33U);
    EXPECT_EQ(errors.skipped, 0U);
    EXPECT_NEAR(errors.all.translation_m.max, 0.0, 1e-9);
    EXPECT_NEAR(errors.all.rotation_deg.max, 0.0, 1e-6);
}

TEST(Relations, ErrorIsTheMotionLeftOver) {
    const Trajectory two_poses{{0, {1.0, 1.0, 0.0}}, {1'000'000'000, {1.0, 3.0, 0.5}}};
    const Pose2 leftover{0.03, -0.04, -0.1};
    const Relation relation{0, 1'000'000'000, Pose2{0.0, 2.0, 0.5} * leftover};
    const RelationErrors errors = score_relations(two_poses, {relation});
    EXPECT_NEAR(errors.errors_m.at(0), 0.05, 1e-12);
    EXPECT_NEAR(errors.errors_deg.at(0), 0.1 * 180.0 / std::acos(-1.0), 1e-9);
}

TEST(Relations, AreScoredApartByTheTimeBetweenThem) {
    Trajectory path;
    for (int second : {0, 4, 30, 100}) {
        path.push_back({second * std::int64_t{1'000'000'000}, {1.0 * second, 0.0, 0.0}});
    }
    const auto relation = [&](std::size_t from, std::size_t to, double error_m) {
        return Relation{path[from].stamp_ns, path[to].stamp_ns,
                        between(path[from].pose, path[to].pose) * Pose2{error_m, 0.0, 0.0}};
    };
    const RelationErrors errors =
        score_relations(path, {relation(0, 1, 0.1), relation(1, 2, 0.2), relation(0, 3, 0.6), relation(3, 1, 0.8)});
    EXPECT_NEAR(errors.all.translation_m.mean, 0.425, 1e-9);
    ASSERT_TRUE(errors.short_ones && errors.long_ones);
    EXPECT_EQ(errors.short_ones->translation_m.count, 1U);
    EXPECT_NEAR(errors.short_ones->translation_m.mean, 0.1, 1e-9);
    EXPECT_EQ(errors.long_ones->rotation_deg.count, 2U);
    EXPECT_NEAR(errors.long_ones->translation_m.mean, 0.7, 1e-9);
    EXPECT_FALSE(score_relations(path, {relation(1, 2, 0.2)}).long_ones);
}

TEST(Relations, DoNotDependOnTheOrderOfThePosesOrOfTheirOwn) {
    const Trajectory path = wandering_path(40, 2);
    Trajectory estimate = noisy(path, 3);
    std::vector<Relation> relations = relations_of(path, 5);
    const RelationErrors in_order = score_relations(estimate, relations);
    std::swap(estimate[3], estimate[20]);
    std::reverse(relations.begin(), relations.end());
    const RelationErrors shuffled = score_relations(estimate, relations);
    EXPECT_GT(in_order.all.translation_m.mean, 0.01);
    EXPECT_NEAR(shuffled.all.translation_m.mean, in_order.all.translation_m.mean, 1e-12);
    EXPECT_NEAR(shuffled.all.rotation_deg.max, in_order.all.rotation_deg.max, 1e-12);
}

TEST(Relations, AreSkippedAndCountedWhereATimeIsMissing) {
    const Trajectory path = wandering_path(10, 4);
    std::vector<Relation> relations = relations_of(path, 3);
    relations[2].to_ns += 50'000'000;
    relations[5].from_ns = -1'000'000'000;
    const RelationErrors errors = score_relations(path, relations);
    EXPECT_EQ(errors.skipped, 2U);
    EXPECT_EQ(errors.all.translation_m.count, relations.size() - 2);
    EXPECT_EQ(score_relations(path, relations, 0.06).skipped, 1U);
}

class RelationsFile : public testing::Test {
protected:
    ~RelationsFile() override { std::filesystem::remove(path_); }
    void write(const std::string& content) { std::ofstream(path_) << content; }

    std::filesystem::path path_ =
        std::filesystem::path(testing::TempDir()) /
        (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".relations");
};

TEST_F(RelationsFile, IsReadToTheMicrosecond) {
    write("# a comment\n\n976052905.167303 976052911.885496 -0.5 0.25 9 8 7 -1.5\r\n");
    const std::vector<Relation> relations = read_relations(path_);
    ASSERT_EQ(relations.size(), 1U);
    EXPECT_EQ(relations[0].from_ns, 976'052'905'167'303'000);
    EXPECT_EQ(relations[0].to_ns, 976'052'911'885'496'000);
    EXPECT_EQ(relations[0].motion, (Pose2{-0.5, 0.25, -1.5}));
}

TEST_F(RelationsFile, OfAnotherShapeIsRefusedWithItsLine) {
    for (const std::string bad : {"1 2 3 4 5 6 7", "1 2 3 4 5 6 7 8 9", "1 2 x 4 5 6 7 8", "1 2 nan 4 5 6 7 8"}) {
        write("1 2 3 4 5 6 7 8\n" + bad + "\n");
        try {
            read_relations(path_);
            ADD_FAILURE() << bad;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(":2: expected eight numbers"));
        }
    }
}

TEST_F(RelationsFile, ThatIsMissingIsNamed) {
    try {
        read_relations(path_);
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(path_.string()));
    }
}

}  // namespace
}  // namespace ddtool
