#include "study/ablation/plan.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "ddtool/base/error.hpp"
#include "thrown_text.hpp"

namespace ddtool::ablation {
namespace {

Plan plan_of(const Json& changes) {
    Json json = default_plan_json();
    merge_settings(json, changes, "test");
    return plan_from_json(json);
}

const Json one_row = {{"name", "one"}, {"train", {{"loss", "bce"}}}, {"paper", {{"accuracy", 0.9}}}};

TEST(Plan, RowsTakeTheCommonSettingsAndChangeTheirOwn) {
    const Plan plan = plan_of({{"seeds", {4}}, {"train", {{"epochs", 3}}}, {"rows", {one_row}}});
    EXPECT_EQ(plan.seeds, std::vector<std::uint64_t>{4});
    ASSERT_EQ(plan.rows.size(), 1U);
    EXPECT_EQ(plan.rows[0].settings.epochs, 3U);
    EXPECT_EQ(plan.rows[0].settings.loss, "bce");
    EXPECT_EQ(plan.rows[0].paper.accuracy, 0.9);
    EXPECT_TRUE(std::isnan(plan.rows[0].paper.f1));
}

TEST(Plan, MistakesAreNamedByTheirPlace) {
    const auto complaint = [](const Json& changes) {
        return ddtool::test::thrown_text<UsageError>([&] { (void)plan_of(changes); });
    };
    Json wrong = one_row;
    wrong["train"]["loss"] = "hinge";
    EXPECT_THAT(complaint({{"rows", {one_row, wrong}}}), testing::StartsWith("rows[1].train.loss: "));
    wrong = one_row;
    wrong["train"] = {{"seed", 3}};
    EXPECT_THAT(complaint({{"rows", {wrong}}}), testing::HasSubstr("rows[0]: unknown setting 'train.seed'"));
    wrong = one_row;
    wrong["paper"]["f1"] = "high";
    EXPECT_THAT(complaint({{"rows", {wrong}}}), testing::StartsWith("rows[0].paper.f1: expected a number"));
    EXPECT_THAT(complaint({{"rows", {one_row}}, {"timings", {{{"row", "two"}}}}}),
                testing::StartsWith("timings[0].row: "));
    EXPECT_THAT(complaint({{"rows", Json::array()}}), testing::HasSubstr("one or more"));
}

TEST(Plan, ThatOfThePaperHasEveryRowOfItsTableAndTheOthersAreOnesToo) {
    for (const auto& [name, rows] : {std::pair("paper", 11U), std::pair("paper-pairing", 14U), std::pair("quick", 5U),
                                     std::pair("swarms", 13U), std::pair("two-cores", 10U)}) {
        Json json = default_plan_json();
        merge_settings_file(json, std::string(DDTOOL_SOURCE_DIR) + "/configs/ablation/" + name + ".json");
        const Plan plan = plan_from_json(json);
        EXPECT_EQ(plan.rows.size(), rows);
        std::set<std::string> trainings;
        for (const Row& row : plan.rows) {
            trainings.insert(Json(row.settings).dump());
        }
        EXPECT_EQ(trainings.size(), rows) << "no row is another's copy";
    }
}

}  // namespace
}  // namespace ddtool::ablation
