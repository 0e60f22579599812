#include "run/run_explorer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "small_run.hpp"

namespace ddtool {
namespace {

/// Does the same as `ddtool slam`, with a detector whose answers the test chooses.
struct ShownRun {
    explicit ShownRun(bool with_truth = true, RunCourse empty_course = RunCourse()) : course(std::move(empty_course)) {
        test::SmallRun small;
        run = small.run([&](const SensorFrame&, const std::optional<Update>& update) {
            if (update) {
                course.add(*update, summary_of(*update));
            }
            return true;
        });
        if (!with_truth) {
            run.ground_truth.clear();
        }
        explorer = run_explorer(run, map_raster(run.map), course);
    }

    [[nodiscard]] std::set<std::string> line_names() const {
        std::set<std::string> names;
        for (const Json& line : explorer.data.at("lines")) {
            names.insert(line.at("name"));
        }
        return names;
    }

    RunCourse course;
    FilterRun run;
    RunExplorer explorer;
};

TEST(RunCourse, HasALineForEveryUpdate) {
    const ShownRun shown;
    EXPECT_EQ(shown.course.updates().size(), shown.run.updates);
    for (const UpdateSummary& update : shown.course.updates()) {
        EXPECT_GT(update.step_s, 0.0);
        EXPECT_THAT(update.effective_size, testing::AllOf(testing::Ge(1.0), testing::Le(3.001)));
    }
}

TEST(RunCourse, OfALongRunKeepsEveryFewUpdatesAndWhetherThereWasResampling) {
    constexpr std::size_t most = 8;
    const std::vector<UpdateSummary> all = ShownRun().course.updates();
    const ShownRun shown(true, RunCourse(most));
    const std::vector<UpdateSummary>& kept = shown.course.updates();
    ASSERT_GT(all.size(), 2 * most);
    EXPECT_THAT(kept.size(), testing::AllOf(testing::Gt(most / 2), testing::Le(most)));
    const std::size_t every = (all.size() + kept.size() - 1) / kept.size();
    for (std::size_t row = 0; row < kept.size(); ++row) {
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(row * every);
        const auto last = all.end() - first > static_cast<std::ptrdiff_t>(every)
                              ? first + static_cast<std::ptrdiff_t>(every)
                              : all.end();
        EXPECT_EQ(kept[row].stamp_ns, first->stamp_ns);
        EXPECT_EQ(kept[row].resampled,
                  std::any_of(first, last, [](const UpdateSummary& update) { return update.resampled; }));
    }
}

TEST(PlacesOf, LieOnThePathAtTheUpdates) {
    const ShownRun shown;
    const Trajectory places = places_of(shown.course.updates(), shown.run.trajectory);
    for (std::size_t index = 0; index < places.size(); ++index) {
        EXPECT_EQ(places[index].stamp_ns, shown.course.updates()[index].stamp_ns);
        EXPECT_TRUE(std::any_of(shown.run.trajectory.begin(), shown.run.trajectory.end(), [&](const StampedPose& scan) {
            return scan.stamp_ns == places[index].stamp_ns && scan.pose == places[index].pose;
        }));
    }
}

TEST(RunExplorer, ShowsEveryUpdateOfAShortRun) {
    const ShownRun shown;
    const Json& data = shown.explorer.data;
    EXPECT_EQ(data.at("x").at("values").size(), shown.course.updates().size());
    EXPECT_EQ(data.at("place").at("x_m").size(), shown.course.updates().size());
    for (const Json& line : data.at("lines")) {
        EXPECT_EQ(line.at("values").size(), shown.course.updates().size()) << line.at("name");
    }
}

TEST(RunExplorer, LeavesOutLinesThatSayNothing) {
    const ShownRun shown;
    EXPECT_THAT(shown.line_names(), testing::UnorderedElementsAre("spread of the particles", "effective sample size",
                                                                  "distance from the truth", "step time"));
    EXPECT_FALSE(ShownRun(false).line_names().contains("distance from the truth"));
    EXPECT_FALSE(ShownRun(false).explorer.data.contains("reference"));
}

TEST(RunExplorer, LaysTheTruthOnThePath) {
    const Json data = ShownRun().explorer.data;
    const Json& truth = data.at("reference");
    const Json& place = data.at("place");
    ASSERT_EQ(truth.at("x_m").size(), place.at("x_m").size());
    for (std::size_t row = 0; row < truth.at("x_m").size(); ++row) {
        EXPECT_NEAR(truth.at("x_m")[row], place.at("x_m")[row], 0.1);
        EXPECT_NEAR(truth.at("y_m")[row], place.at("y_m")[row], 0.1);
    }
}

TEST(RunExplorer, StandsWithoutAnyUpdate) {
    FilterRun run;
    run.trajectory = {{0, {}}};
    const RunExplorer explorer = run_explorer(run, map_raster(run.map), {});
    EXPECT_TRUE(explorer.updates.empty());
    EXPECT_TRUE(explorer.data.at("lines").empty());
}

}  // namespace
}  // namespace ddtool
