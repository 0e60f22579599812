#include "dataset/run_plan.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "dataset/build_settings.hpp"
#include "dataset/parts.hpp"
#include "thrown_text.hpp"

namespace ddtool::dataset {
namespace {

using ddtool::test::thrown_text;
using testing::HasSubstr;

RunPlan planned(const Json& changes) {
    Json settings = default_build_json();
    merge_settings(settings, changes, "test");
    return plan_runs(settings);
}

std::set<std::string> ids_of(const RunPlan& plan) {
    std::set<std::string> ids;
    for (const PlannedRun& run : plan.runs) {
        ids.insert(run.entry.id);
    }
    return ids;
}

const Json mix{{"particles", {15, 30, 60}},
               {"lidars", {"ls-m10p", "sick-lms"}},
               {"update_distances", {{0.5, 0.25}}},
               {"methods", {"rbpf", "paper-strategies-on-ours"}}};

TEST(PlanRuns, DrawsEachRunFromTheMix) {
    const Json worlds = Json::array({{{"world", "random:office:{seed}"}, {"seeds", {{"first", 5}, {"count", 40}}}}});
    const RunPlan plan = planned({{"worlds", worlds}, {"mix", mix}});
    ASSERT_EQ(plan.runs.size(), 40U);
    std::map<std::uint64_t, int> particles;
    std::set<std::string> methods;
    for (const PlannedRun& run : plan.runs) {
        ++particles[run.entry.particles];
        EXPECT_EQ(run.entry.update_distance_m, 0.5);
        EXPECT_EQ(run.key.configuration().at("filter").at("particles"), run.entry.particles);
        EXPECT_EQ(run.key.configuration().at("simulation").at("lidar").at("preset"), run.entry.lidar);
        EXPECT_EQ(run.key.configuration().at("filter").at("seed"), run.entry.seed);
        // data sets were published when these had other names
        EXPECT_EQ(run.key.configuration().at("filter").at("method"), run.entry.method == "rbpf" ? "gmapping" : "paper");
        methods.insert(run.entry.method);
    }
    EXPECT_EQ(methods.size(), 2U);
    EXPECT_EQ(particles.size(), 3U);
    EXPECT_EQ(plan.runs[0].entry.scene, "random:office:5");
    EXPECT_EQ(plan.sources[39].name, "random:office:44");
}

TEST(PlanRuns, AnotherSourceLeavesTheRunsOfTheOthersAlone) {
    const auto few = ids_of(planned({{"worlds", {"s1", "s2"}}, {"mix", mix}}));
    const auto more = ids_of(planned({{"worlds", {"r1", "s2", "s1"}}, {"mix", mix}}));
    EXPECT_TRUE(std::includes(more.begin(), more.end(), few.begin(), few.end()));
    EXPECT_EQ(more.size(), 3U);
}

TEST(PlanRuns, OnlyWhatDecidesTheSamplesDecidesTheId) {
    const auto ids = [](const Json& changes) {
        Json settings{{"worlds", Json::array({{{"world", "s1"}, {"scene", "hall"}}})}};
        settings.update(changes);
        return ids_of(planned(settings));
    };
    const auto plain = ids(Json::object());
    EXPECT_EQ(ids({{"labels", {{"dispersion_threshold", 2.0}}}}), plain);
    EXPECT_EQ(ids({{"balance", {{"degenerate", 5}}}}), plain);
    EXPECT_NE(ids({{"thinning", {{"every", 9}}}}), plain);
    EXPECT_NE(ids({{"filter", {{"particles", 9}}}}), plain);
    EXPECT_NE(ids({{"seed", 2}}), plain);
}

TEST(PlanRuns, IdsAreThoseOfTheVersionsBefore) {
    const Json settings{
        {"worlds", Json::array({{{"world", "s1"}, {"seeds", {{"count", 2}}}}})},
        {"mix",
         {{"particles", {2, 3}},
          {"odometry", {"good", "poor"}},
          {"update_distances", Json::array({Json::array({0.5, 0.3})})}}},
        {"most_particle_updates", 60},
        {"filter", {{"method", "anti-degeneracy"}, {"full_weight_sd_m", 0.0}, {"fusion", {{"least_degree", 0.25}}}}},
        {"simulation", {{"lidar", {{"beams", 60}, {"rate_hz", 2.0}}}}}};
    EXPECT_EQ(ids_of(planned(settings)), (std::set<std::string>{"06ed51f0289efcf3", "aeaa0d8ece8d61e2"}))
        << "an id decides which snapshots are kept, so that another id is another data set";
}

TEST(PlanRuns, UpdateDistancesAreThoseOfTheMethodsFilter) {
    for (const char* method : {"rbpf", "gmapping"}) {
        Json one = mix;
        one["methods"] = {method};
        const RunPlan drawn = planned({{"worlds", {"s1"}}, {"mix", one}});
        EXPECT_EQ(drawn.runs.front().entry.update_distance_m, 0.5) << method;
        EXPECT_EQ(drawn.runs.front().entry.update_turn_rad, 0.25) << method;
    }
    const RunPlan plain = planned({{"worlds", {"s1"}}, {"filter", {{"method", "gmapping"}}}});
    EXPECT_EQ(plain.runs.front().entry.update_distance_m, GmappingSettings{}.update_distance_m);
}

TEST(PlanRuns, TakesThePlainFilterUnlessToldOtherwise) {
    EXPECT_EQ(planned({{"worlds", {"s1"}}}).runs.front().entry.method, "rbpf");
    for (const char* name : {"default", "small", "label-noise"}) {
        Json file = default_build_json();
        merge_settings_file(file, std::string(DDTOOL_SOURCE_DIR) + "/configs/dataset/" + name + ".json");
        for (const PlannedRun& run : plan_runs(file).runs) {
            EXPECT_EQ(run.entry.method, "rbpf") << name;
        }
    }
}

TEST(PlanRuns, EqualRunsAreOne) { EXPECT_EQ(planned({{"worlds", {"s1", "s1"}}}).runs.size(), 1U); }

TEST(PlanRuns, ATexturedWorldIsTheSceneOfThePlainOne) {
    const RunPlan plan = planned({{"worlds", {"s1", "s1-textured"}}});
    ASSERT_EQ(plan.runs.size(), 2U);
    EXPECT_EQ(plan.runs[0].entry.scene, "s1");
    EXPECT_EQ(plan.runs[1].entry.scene, "s1");
    EXPECT_NE(plan.runs[0].entry.id, plan.runs[1].entry.id);
}

TEST(PlanRuns, NamesWhatMakesNoSense) {
    const auto said = [](const Json& changes) { return thrown_text<UsageError>([&] { (void)planned(changes); }); };
    EXPECT_THAT(said(Json::object()), HasSubstr("worlds, logs, snapshots: expected one or more"));
    EXPECT_THAT(said({{"worlds", {"s9"}}}), HasSubstr("unknown world 's9'"));
    EXPECT_THAT(said({{"worlds", {{{"wrld", "s1"}}}}}), HasSubstr("worlds[0]: unknown setting 'wrld'"));
    EXPECT_THAT(said({{"worlds", Json::array({{{"scene", "x"}}})}}),
                HasSubstr("worlds[0]: expected the name of a world"));
    EXPECT_THAT(said({{"worlds", {"s1"}}, {"mix", {{"particles", {"many"}}}}}),
                HasSubstr("worlds[0].mix.particles: expected numbers of particles"));
    EXPECT_THAT(said({{"worlds", {"s1"}}, {"mix", {{"update_distances", {0.1}}}}}),
                HasSubstr("expected pairs [metres, radians]"));
    EXPECT_THAT(said({{"worlds", {"s1"}}, {"mix", {{"particles", {0}}}}}), HasSubstr("particles: expected numbers"));
    EXPECT_THAT(said({{"worlds", {"s1"}}, {"filter", {{"update_turn_rad", 0.0}}}}),
                HasSubstr("filter.update_turn_rad"));
    EXPECT_THAT(said({{"worlds", {"s1"}}, {"thinning", {{"every", 0}}}}), HasSubstr("thinning.every: expected"));
}

TEST(ParseWorkShare, TakesOneToN) {
    EXPECT_EQ(parse_work_share("3/8").index, 3U);
    EXPECT_EQ(parse_work_share("3/8").count, 8U);
    for (const char* wrong : {"0/8", "9/8", "3", "3/", "/8", "3/8x", "-1/8", "1.5/2"}) {
        EXPECT_THAT(thrown_text<UsageError>([&] { parse_work_share(wrong); }), HasSubstr("i from 1 to n")) << wrong;
    }
}

TEST(WorkShare, TogetherHaveEveryRunOnce) {
    for (std::size_t run = 0; run < 20; ++run) {
        int owners = 0;
        for (std::size_t index = 1; index <= 3; ++index) {
            owners += WorkShare{index, 3}.has(run) ? 1 : 0;
        }
        EXPECT_EQ(owners, 1);
    }
}

}  // namespace
}  // namespace ddtool::dataset
