#include "dataset/scene_split.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "ddtool/base/random.hpp"

namespace ddtool::dataset {
namespace {

std::vector<SceneCounts> drawn_scenes(std::uint64_t seed, std::size_t count) {
    RandomStream random({seed});
    std::vector<SceneCounts> scenes(count);
    for (SceneCounts& scene : scenes) {
        for (std::size_t& group : scene) {
            group = random.index(2) == 0 ? 0 : random.index(60);
        }
    }
    return scenes;
}

/// The sum of the squared deviations from 6:2:2, as the header defines the cost.
double cost_of(const std::vector<SceneCounts>& scenes, const std::vector<Part>& parts) {
    double cost = 0.0;
    for (std::size_t group = 0; group < 4; ++group) {
        double total = 0.0;
        std::array<double, 4> filled{};
        for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
            total += static_cast<double>(scenes[scene][group]);
            filled[index_of(parts[scene])] += static_cast<double>(scenes[scene][group]);
        }
        const std::array<double, 4> shares{0.0, 0.6, 0.2, 0.2};
        for (std::size_t part = 1; part < 4 && total > 0.0; ++part) {
            cost += (filled[part] / total - shares[part]) * (filled[part] / total - shares[part]);
        }
    }
    return cost;
}

double least_cost(const std::vector<SceneCounts>& scenes) {
    std::size_t assignments = 1;
    for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
        assignments *= 3;
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t number = 0; number < assignments; ++number) {
        std::vector<Part> parts;
        for (std::size_t rest = number; parts.size() < scenes.size(); rest /= 3) {
            parts.push_back(static_cast<Part>(1 + rest % 3));
        }
        least = std::min(least, cost_of(scenes, parts));
    }
    return least;
}

TEST(PartsOfScenes, ComeNearTheBestOfAllAssignments) {
    double excess = 0.0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const std::vector<SceneCounts> scenes = drawn_scenes(seed, 8);
        excess += cost_of(scenes, parts_of_scenes(scenes)) - least_cost(scenes);
    }
    EXPECT_LT(excess / 20.0, 0.02);
}

TEST(PartsOfScenes, ComeCloseToSixToTwoToTwoWhereScenesAreMany) {
    const std::vector<SceneCounts> scenes = drawn_scenes(5, 80);
    EXPECT_LT(cost_of(scenes, parts_of_scenes(scenes)), 1e-4);  // corresponds to a deviation of 0.3 % for each share
}

TEST(PartsOfScenes, AreTheSameEachTime) {
    const std::vector<SceneCounts> scenes = drawn_scenes(6, 30);
    EXPECT_EQ(parts_of_scenes(scenes), parts_of_scenes(scenes));
}

TEST(PartsOfScenes, WorkForOneSceneAndForNone) {
    EXPECT_THAT(parts_of_scenes({{5, 5, 5, 5}}), testing::ElementsAre(Part::train));
    EXPECT_TRUE(parts_of_scenes({}).empty());
}

TEST(HoldOutScenes, GivesAllRunsOfASceneOnePartForBothRules) {
    RandomStream random({9});
    std::vector<RunEntry> runs(20);
    for (RunEntry& run : runs) {
        run.scene = std::string(1, static_cast<char>('a' + random.index(7)));
    }
    std::vector<SampleRecord> records(500);
    for (SampleRecord& record : records) {
        record.run = static_cast<std::uint32_t>(random.index(runs.size()));
        record.label = {static_cast<Label>(random.index(2)), static_cast<Label>(random.index(2))};
        record.part[0][0] = random.index(3) == 0 ? Part::unused : Part::train;
        record.part[1][0] = random.index(3) == 0 ? Part::unused : Part::test;
    }
    hold_out_scenes(records, runs);
    std::array<Part, 7> part_of{};
    for (const SampleRecord& record : records) {
        for (const LabelRule rule : {LabelRule::dispersion, LabelRule::fisher}) {
            const Part part = record.part_of(rule, Split::held_out);
            EXPECT_EQ(part == Part::unused, record.part_of(rule, Split::paper) == Part::unused);
            Part& expected = part_of[static_cast<std::size_t>(runs[record.run].scene[0] - 'a')];
            expected = expected == Part::unused ? part : expected;
            EXPECT_TRUE(part == Part::unused || part == expected);
        }
    }
}

}  // namespace
}  // namespace ddtool::dataset
