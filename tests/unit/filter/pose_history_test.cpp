#include "ddtool/filter/pose_history.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

/// A model of the same tree with shared pointers. It counts the nodes that exist.
struct ModelNode {
    explicit ModelNode(std::shared_ptr<ModelNode> its_parent, const Pose2& its_pose)
        : parent(std::move(its_parent)), pose(its_pose) {
        ++living;
    }
    ~ModelNode() { --living; }
    ModelNode(const ModelNode&) = delete;
    ModelNode& operator=(const ModelNode&) = delete;

    std::shared_ptr<ModelNode> parent;
    Pose2 pose;
    static inline std::size_t living = 0;
};

std::vector<Pose2> path_of(const ModelNode* node) {
    std::vector<Pose2> poses;
    for (; node != nullptr; node = node->parent.get()) {
        poses.insert(poses.begin(), node->pose);
    }
    return poses;
}

struct Walker {
    PoseHistory::Node node = PoseHistory::none;
    std::shared_ptr<ModelNode> model;
};

void step(PoseHistory& history, Walker& walker, RandomStream& random) {
    const Pose2 pose{random.normal(), random.normal(), random.normal()};
    const PoseHistory::Node parent = walker.node;
    walker.node = history.add(parent, pose);
    history.release(parent);
    walker.model = std::make_shared<ModelNode>(walker.model, pose);
}

void become_copy(PoseHistory& history, Walker& walker, const Walker& other) {
    if (other.node != PoseHistory::none) {
        history.acquire(other.node);
    }
    history.release(walker.node);
    walker = other;
}

TEST(PoseHistory, KeepsThePathsOfTheLivingAndNothingElse) {
    RandomStream random{1};
    PoseHistory history;
    std::vector<Walker> walkers(8);
    for (int i = 0; i < 1'500; ++i) {
        Walker& walker = walkers[random.index(walkers.size())];
        if (random.uniform() < 0.6) {
            step(history, walker, random);
        } else {
            become_copy(history, walker, walkers[random.index(walkers.size())]);
        }
        ASSERT_EQ(history.size(), ModelNode::living) << i;
        const std::vector<Pose2> path = path_of(walker.model.get());
        ASSERT_EQ(history.path(walker.node), path) << i;
        for (std::size_t back = 0; back < path.size(); ++back) {
            ASSERT_EQ(history.pose_before(walker.node, back), path[path.size() - 1 - back]) << i;
        }
    }
    for (Walker& walker : walkers) {
        ASSERT_EQ(history.path(walker.node), path_of(walker.model.get()));
        history.release(walker.node);
        walker.model.reset();
        EXPECT_EQ(history.size(), ModelNode::living);
    }
    EXPECT_EQ(history.size(), 0U);
}

/// The ancestors of all particles meet a few resamplings back, so the tree is hardly larger than a single path.
TEST(PoseHistory, OfAResampledSwarmGrowsWithTheRunAlone) {
    constexpr std::size_t particles = 30;
    constexpr std::size_t updates = 1'000;
    RandomStream random{2};
    PoseHistory history;
    std::vector<Walker> walkers(particles);
    for (std::size_t update = 0; update < updates; ++update) {
        for (Walker& walker : walkers) {
            step(history, walker, random);
        }
        for (Walker& walker : walkers) {
            become_copy(history, walker, walkers[random.index(particles)]);
        }
    }
    EXPECT_EQ(history.path(walkers[0].node).size(), updates);
    EXPECT_LT(history.size(), updates + 40 * particles);
}

TEST(PoseHistory, ForgetsWhatIsBeforeACommonAncestor) {
    RandomStream random{3};
    PoseHistory history;
    Walker trunk;
    for (int i = 0; i < 10; ++i) {
        step(history, trunk, random);
    }
    Walker branch;
    become_copy(history, branch, trunk);
    step(history, trunk, random);
    step(history, branch, random);
    const PoseHistory::Node common = history.ancestor(trunk.node, 4);
    EXPECT_EQ(history.ancestor(branch.node, 4), common);
    const std::vector<Pose2> whole = history.path(branch.node);
    history.forget_before(common);
    EXPECT_EQ(history.size(), 6U);
    EXPECT_EQ(history.path(branch.node), std::vector<Pose2>(whole.begin() + 6, whole.end()));
    EXPECT_EQ(history.ancestor(trunk.node, 100), common);
    history.release(trunk.node);
    history.release(branch.node);
    EXPECT_EQ(history.size(), 0U);
}

TEST(PoseHistory, OfNoNodeIsNoPath) {
    PoseHistory history;
    EXPECT_TRUE(history.path(PoseHistory::none).empty());
    history.release(PoseHistory::none);
    EXPECT_EQ(history.size(), 0U);
}

}  // namespace
}  // namespace ddtool
