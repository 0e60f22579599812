#include "study/compare/experiment.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "temporary_folder.hpp"
#include "thrown_text.hpp"
#include "tiny_experiment.hpp"

namespace ddtool::compare {
namespace {

using ddtool::test::TemporaryFolder;
using ddtool::test::thrown_text;
using ::testing::AllOf;
using ::testing::HasSubstr;

class ExperimentTest : public ::testing::Test {
protected:
    [[nodiscard]] std::vector<std::string> ids(const Json& settings) const {
        std::vector<std::string> all;
        for (const Cell& cell : cells_of(experiment_from_json(settings))) {
            all.push_back(cell.key.id());
        }
        return all;
    }

    TemporaryFolder folder_;
    Json settings_ = test::tiny_settings(ddtool::test::write_tiny_world(folder_ / "tiny.json"));
};

TEST_F(ExperimentTest, HasACellForEveryWorldMethodAndSeed) {
    settings_["worlds"].push_back("s1");
    const auto cells = cells_of(experiment_from_json(settings_));
    std::set<std::array<std::size_t, 3>> places;
    for (const Cell& cell : cells) {
        places.insert({cell.world, cell.contestant, cell.seed});
    }
    EXPECT_EQ(cells.size(), 2U * 2U * 3U);
    EXPECT_EQ(places.size(), cells.size());
    EXPECT_TRUE(
        std::is_sorted(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.seed < b.seed; }));
}

TEST_F(ExperimentTest, GivesEveryMethodOfARunTheSameDataAndEverySeedOther) {
    const auto cells = cells_of(experiment_from_json(settings_));
    EXPECT_EQ(cells[0].data_id, cells[1].data_id);
    EXPECT_NE(cells[0].data_id, cells[2].data_id);
}

TEST_F(ExperimentTest, IdsAreTheSameForTheSameConfigurationWhateverItsOrder) {
    Json other = default_experiment_json();
    Json changes = Json::object();
    std::vector<std::string> keys;
    for (const auto& item : settings_.items()) {
        keys.insert(keys.begin(), item.key());
    }
    for (const std::string& key : keys) {
        changes[key] = settings_[key];
    }
    merge_settings(other, changes, "test");
    EXPECT_EQ(ids(settings_), ids(other));
}

TEST_F(ExperimentTest, IdsDoNotDependOnNames) {
    const auto before = ids(settings_);
    settings_["methods"][1]["name"] = "renamed";
    settings_["worlds"][0]["name"] = "renamed";
    EXPECT_EQ(ids(settings_), before);
}

TEST_F(ExperimentTest, AFilterSettingChangesTheIdsOfFiltersAlone) {
    const auto before = ids(settings_);
    settings_["filter"]["grid"]["cell_size_m"] = 0.1;
    const auto after = ids(settings_);
    EXPECT_EQ(after[0], before[0]);
    EXPECT_NE(after[1], before[1]);
}

TEST_F(ExperimentTest, EverythingThatDecidesTheDataChangesAllIds) {
    const auto before = ids(settings_);
    Json other_lidar = settings_;
    other_lidar["simulation"]["lidar"]["beams"] = 91;
    Json other_score = settings_;
    other_score["score"]["align"] = "none";
    const auto with_lidar = ids(other_lidar);
    const auto with_score = ids(other_score);
    ddtool::test::write_tiny_world(folder_ / "tiny.json", 1.9);
    const auto with_world = ids(settings_);
    for (std::size_t index = 0; index < before.size(); ++index) {
        EXPECT_EQ((std::set{before[index], with_lidar[index], with_score[index], with_world[index]}).size(), 4U);
    }
}

TEST_F(ExperimentTest, ASeedInTheWorldsNameDrawsAnotherWorldEverySeed) {
    settings_["worlds"] = Json::array({"random:open:{seed}"});
    const auto cells = cells_of(experiment_from_json(settings_));
    EXPECT_EQ(cells[0].key.configuration().at("data").at("world"), "random:open:1");
    EXPECT_EQ(cells[2].key.configuration().at("data").at("world"), "random:open:2");
}

TEST_F(ExperimentTest, NamesTheNearestKeyForAnUnknownOne) {
    settings_["methods"][1]["filter"] = {{"partikles", 3}};
    EXPECT_THAT(thrown_text<UsageError>([&] { experiment_from_json(settings_); }),
                AllOf(HasSubstr("methods[1]"), HasSubstr("partikles"), HasSubstr("filter.particles")));
}

TEST_F(ExperimentTest, RefusesWhatMakesNoSense) {
    const auto refusal = [&](const std::string& pointer, const Json& value) {
        Json changed = settings_;
        changed[Json::json_pointer(pointer)] = value;
        return thrown_text<UsageError>([&] { cells_of(experiment_from_json(changed)); });
    };
    EXPECT_THAT(refusal("/methods", Json::array()), HasSubstr("methods: expected one or more"));
    EXPECT_THAT(refusal("/worlds/0/world", "s99"), HasSubstr("s99"));
    EXPECT_THAT(refusal("/methods/1/name", "odometry"), HasSubstr("given before"));
    EXPECT_THAT(refusal("/methods/1/kind", "magic"), HasSubstr("expected filter, odometry, external or known-map"));
    EXPECT_THAT(refusal("/methods/1/filter", {{"particles", 0}}), HasSubstr("particles"));
    EXPECT_THAT(refusal("/baseline", "filtre"), HasSubstr("did you mean: filter"));
    EXPECT_THAT(refusal("/seeds/count", 0U), HasSubstr("seeds.count"));
    EXPECT_THAT(refusal("/seeds/count", std::uint64_t{1} << 60U), HasSubstr("seeds.count"));
    EXPECT_THAT(refusal("/simulation/lidar/preset", "none"), HasSubstr("none"));
}

TEST_F(ExperimentTest, TakesPrintedErrorsOfItsOwnWorldsAndNamesMistakes) {
    settings_["paper"] = Json::parse(R"([{"world": "tiny", "errors_m": {"filter": [3, 2, 1], "peer": null}},
                                         {"world": "s9", "errors_m": {"filter": [3, 2, 1]}}])");
    const std::vector<PrintedErrors> paper = experiment_from_json(settings_).paper;
    ASSERT_EQ(paper.size(), 2U);
    EXPECT_EQ(paper[0].errors_m[2], 1.0);
    EXPECT_TRUE(std::isnan(paper[1].errors_m[0]));
    settings_["paper"][1]["errors_m"]["filter"] = {1, 2};
    EXPECT_THAT(thrown_text<UsageError>([&] { (void)experiment_from_json(settings_); }),
                HasSubstr("paper[1].errors_m.filter: expected ATE, Error_x and Error_y"));
    settings_["paper"] = {{{"wold", "s1"}}};
    EXPECT_THAT(thrown_text<UsageError>([&] { (void)experiment_from_json(settings_); }),
                HasSubstr("paper[0]: expected"));
}

}  // namespace
}  // namespace ddtool::compare
