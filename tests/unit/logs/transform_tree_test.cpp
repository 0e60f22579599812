#include "logs/stream/transform_tree.hpp"

#include <gmock/gmock.h>

namespace ddtool {
namespace {

Eigen::Isometry3d some_transform(double seed) {
    return Eigen::Translation3d(seed, -2.0 * seed, 0.3) *
           Eigen::AngleAxisd(seed, Eigen::Vector3d(1.0, seed, -0.5).normalized());
}

TransformTree tree() {
    TransformTree tree;
    tree.set({0, "map", "odom", some_transform(0.1)});
    tree.set({0, "odom", "base", some_transform(0.7)});
    tree.set({0, "base", "laser", some_transform(1.3)});
    tree.set({0, "base", "imu", some_transform(2.9)});
    return tree;
}

TEST(TransformTree, FindsTheWayUpDownAndAcross) {
    EXPECT_TRUE(tree().find("odom", "laser")->isApprox(some_transform(0.7) * some_transform(1.3)));
    EXPECT_TRUE(tree().find("laser", "odom")->isApprox(tree().find("odom", "laser")->inverse()));
    EXPECT_TRUE(tree().find("imu", "laser")->isApprox(some_transform(2.9).inverse() * some_transform(1.3)));
    EXPECT_TRUE(tree().find("imu", "imu")->isApprox(Eigen::Isometry3d::Identity()));
}

TEST(TransformTree, HasNoWayBetweenUnconnectedFrames) {
    EXPECT_FALSE(tree().find("base", "camera"));
    EXPECT_TRUE(tree().find("camera", "camera"));
}

TEST(TransformTree, LaidOverAnotherItsTransformsCount) {
    TransformTree over;
    over.set({0, "base", "laser", some_transform(2.0)});
    over.set({0, "laser", "lens", some_transform(3.0)});
    TransformTree both = tree();
    both.set(over);
    EXPECT_TRUE(both.find("odom", "lens")->isApprox(some_transform(0.7) * some_transform(2.0) * some_transform(3.0)));
}

TEST(TransformTree, NamesWhatHasNoRotationOnTheWay) {
    TransformTree faulty = tree();
    faulty.set({0, "base", "laser", some_transform(1.3), false});
    faulty.set({0, "map", "odom", some_transform(0.1), false});
    EXPECT_THAT(faulty.without_rotation("base", "laser"), testing::ElementsAre("base -> laser"));
    EXPECT_THAT(faulty.without_rotation("base", "imu"), testing::IsEmpty());
    EXPECT_THAT(faulty.without_rotation("none", "laser"), testing::ElementsAre("base -> laser", "map -> odom"));
}

TEST(TransformTree, SurvivesALoop) {
    TransformTree loop = tree();
    loop.set({0, "laser", "map", some_transform(1.0)});
    EXPECT_LE(loop.with_ancestors("laser").size(), 6U);
}

TEST(TransformTree, ListsAncestorsUpToTheRoot) {
    EXPECT_THAT(tree().with_ancestors("laser"), testing::ElementsAre("laser", "base", "odom", "map"));
    EXPECT_THAT(tree().with_ancestors("lost"), testing::ElementsAre("lost"));
}

}  // namespace
}  // namespace ddtool
