#include "study/compare/summary.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "study/compare/result_tables.hpp"
#include "study/compare/shown_run.hpp"

namespace ddtool::compare {
namespace {

/// The results of two methods in two worlds, with ATEs given by a function. A negative ATE stands for a failed run.
struct Made {
    Experiment experiment;
    std::vector<Cell> cells;
    std::vector<CellResult> results;
};

template <typename AteOf>
Made made(std::size_t seeds, AteOf&& ate_of) {
    Made all{.experiment = {}, .cells = {}, .results = {}};
    for (const char* name : {"s1", "s2"}) {
        all.experiment.worlds.emplace_back(Json(name), Json::object(), "test");
    }
    for (const char* name : {"first", "second"}) {
        all.experiment.contestants.emplace_back(Json{{"name", name}, {"kind", "odometry"}}, Json::object(), "test",
                                                DetectorTable());
    }
    for (std::size_t seed = 0; seed < seeds; ++seed) {
        all.experiment.seeds.push_back(seed + 1);
        for (std::size_t world = 0; world < 2; ++world) {
            for (std::size_t method = 0; method < 2; ++method) {
                all.cells.push_back({world, method, seed, nullptr, jobs::Key(Json::object()), ""});
                all.results.emplace_back();
                const double ate_m = ate_of(world, method, seed);
                if (ate_m < 0.0) {
                    all.results.back().failure = "broke";
                } else {
                    all.results.back().score.ate_m.emplace().rmse = ate_m;
                }
            }
        }
    }
    return all;
}

std::vector<Summary> summaries_of(const Made& all) { return summaries_of(all.experiment, all.cells, all.results); }

double better_on_second_world(std::size_t world, std::size_t method, std::size_t seed) {
    return (world == 1 && method == 1 ? 0.1 : 1.0) + 0.01 * static_cast<double>(seed * (1 + method));
}

TEST(Summary, PairsOverSeedsAndCorrectsForTheNumberOfTests) {
    const Made all = made(10, better_on_second_world);
    const std::vector<Summary> summaries = summaries_of(all);
    ASSERT_EQ(summaries.size(), 4U);  // one per method and world, because the runs have only one kind of error
    EXPECT_FALSE(summaries[0].against_baseline);
    EXPECT_DOUBLE_EQ(summaries[3].against_baseline->p_value, std::exp2(-9));
    // Holm's correction multiplies the smaller of the two p-values by 2
    EXPECT_DOUBLE_EQ(summaries[3].holm_p_value, std::exp2(-8));
    EXPECT_LT(summaries[3].against_baseline->median_difference, 0.0);
}

TEST(Summary, DoesNotDependOnTheOrderOfTheCells) {
    Made all = made(7, better_on_second_world);
    const std::string table = full_table(all.experiment, summaries_of(all)).csv();
    std::reverse(all.cells.begin(), all.cells.end());
    std::reverse(all.results.begin(), all.results.end());
    EXPECT_EQ(full_table(all.experiment, summaries_of(all)).csv(), table);
}

TEST(Summary, CountsAFailedRunAsTheWorst) {
    const Made all = made(3, [](std::size_t, std::size_t method, std::size_t seed) {
        return method == 1 && seed == 0 ? -1.0 : 1.0 + static_cast<double>(seed);
    });
    const Summary second = summaries_of(all)[1];
    EXPECT_EQ(second.failed, 1U);
    EXPECT_EQ(median(second.values), 3.0);
    EXPECT_EQ(failure_table(all.experiment, all.cells, all.results).json().size(), 2U);
}

TEST(Summary, HasNoneForAWorldWithoutAnyScore) {
    const Made all = made(3, [](std::size_t world, std::size_t, std::size_t) { return world == 0 ? -1.0 : 1.0; });
    const std::vector<Summary> summaries = summaries_of(all);
    EXPECT_EQ(main_summary(summaries, 0, 1), nullptr);
    EXPECT_NE(main_summary(summaries, 1, 1), nullptr);
    EXPECT_EQ(overview_table(all.experiment, summaries).json()[0]["second"], "failed");
}

TEST(Summary, ShowsTheMiddleSeed) {
    const Made all = made(5, [](std::size_t, std::size_t method, std::size_t seed) {
        const double errors[]{5.0, 1.0, 3.0, 2.0, 4.0};
        return errors[seed] + static_cast<double>(method);
    });
    EXPECT_EQ(median_seed(all.experiment, summaries_of(all), 0), 2U);
}

TEST(PaperTable, HasBothChangesAgainstTheBaselineAndTheMethodsOfThePaperAlone) {
    Made all = made(3, [](std::size_t world, std::size_t method, std::size_t seed) {
        return world == 1 && method == 1 && seed == 2 ? -1.0 : method == 1 ? 0.5 : 2.0;
    });
    EXPECT_TRUE(paper_table(all.experiment, summaries_of(all)).empty());
    all.experiment.paper = {{"s1", "first", {1.0, 0.4, 0.3}}, {"s1", "second", {0.8, 0.2, 0.1}}, {"s1", "peer", {}}};
    const Json rows = paper_table(all.experiment, summaries_of(all)).json();
    ASSERT_EQ(rows.size(), 5U);
    EXPECT_EQ(rows[0].at("paper ATE"), 1.0);
    EXPECT_TRUE(std::isnan(rows[0].at("paper change [%]").get<double>()));
    EXPECT_EQ(rows[1].at("ATE [m]"), 0.5);
    EXPECT_EQ(rows[1].at("change of ATE [%]"), -75.0);
    EXPECT_NEAR(rows[1].at("paper change [%]").get<double>(), -20.0, 1e-9);
    EXPECT_EQ(rows[1].at("paper Error_y"), 0.1);
    EXPECT_EQ(rows[2].at("method"), "peer");
    EXPECT_TRUE(std::isnan(rows[2].at("ATE [m]").get<double>()));
    EXPECT_EQ(rows[4].at("change of ATE [%]"), -75.0) << "of the seeds with which both have ended";
}

}  // namespace
}  // namespace ddtool::compare
