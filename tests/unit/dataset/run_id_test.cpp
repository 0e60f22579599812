#include "dataset/run_id.hpp"

#include <gtest/gtest.h>

#include "jobs/store.hpp"
#include "methods/settings_json.hpp"
#include "system/fingerprint.hpp"

namespace ddtool::dataset {
namespace {

/// The settings in the form in which the runs of the first published data sets stored them.
constexpr const char* published =
    R"({"method":"anti-degeneracy","detector":"","search":"","trust":"","resampling":"","odometry":"",)"
    R"("particles":30,"update_distance_m":0.1,"update_turn_rad":0.1,"resample_share":0.3,"likelihood_gain":0.05,)"
    R"("min_match_score":0.1,"insert_distance_m":0.3,"insert_turn_rad":0.3,)"
    R"("motion":{"translation_per_translation":0.1,"translation_per_rotation":0.1,"rotation_per_translation":0.1,)"
    R"("rotation_per_rotation":0.2},"grid":{"cell_size_m":0.05,"hit_step":6,"free_step":1,"min_log_odds":-30,)"
    R"("max_log_odds":60},"points":{"usable_range_m":40.0,"spacing_m":0.03,"normal_radius_m":0.18,)"
    R"("line_flatness":0.3},"matcher":{"reach_m":0.16,"max_iterations":25,"beam_sigma_m":0.05,"doubtful_score":0.8,)"
    R"("search_turn_rad":0.35,"search_distance_m":0.6},"detection":{"covariance_sd_m":0.1,"doubt_share":0.3,)"
    R"("every_m":0.3},"coarse_fine":{"step_m":0.1,"turn_rad":0.05},"correlative":{"window_m":0.2,"window_rad":0.1,)"
    R"("steps":4,"levels":3,"degenerate_share":0.02},"fusion":{"least_degree":0.25,"normal_error_rad":0.05,)"
    R"("most_deviations":3.0,"settled_m":0.01,"settled_rad":0.003},"eigenvalue_gate":{"least_share":0.02},)"
    R"("enhanced_resampling":{"drop_below":0.5,"perturbation_m":0.01,"least_weight":0.2,"most_weight":5.0},)"
    R"("odometry_learning":{"scale_sd":0.02,"bias_sd_rad_per_s":0.001,"noise":{"translation_per_translation":0.03,)"
    R"("translation_per_rotation":0.01,"rotation_per_translation":0.01,"rotation_per_rotation":0.03},)"
    R"("noise_chords":3.0,"remembered_chords":300.0,"chord_m":1.0,"chord_turn_rad":1.0,"observed_sd_m":0.03,)"
    R"("observed_sd_rad":0.005,"caution":1.5},"seed":7})";

Json configuration() {
    Json filter = common_filter_json();
    filter["seed"] = 7U;
    filter["full_weight_sd_m"] = 0.0;
    filter["fusion"]["least_degree"] = 0.25;
    return {{"log", "0123"}, {"range_sd_m", 0.02}, {"filter", filter}, {"format", 2}};
}

std::string run_id(const Json& configuration) { return jobs::Key(identity_of(configuration)).id(); }

TEST(RunId, IsOfTheTextThatPublishedDataSetsWereMadeOf) {
    EXPECT_EQ(identity_of(configuration()).at("filter").dump(), published);
    const std::string text =
        std::string(R"({"log":"0123","range_sd_m":0.02,"filter":)") + published + R"(,"format":2})";
    EXPECT_EQ(run_id(configuration()), Fingerprint().add(text).hex());
}

TEST(RunId, ChangesWithEverySettingButTheMemorys) {
    const Json plain = configuration();
    for (const char* path :
         {"/filter/particles", "/filter/points/spacing_m", "/filter/fusion/settled_m", "/range_sd_m"}) {
        Json changed = plain;
        changed[Json::json_pointer(path)] = 0.25;
        EXPECT_NE(run_id(changed), run_id(plain)) << path;
    }
    Json changed = plain;
    changed["filter"]["grid"]["most_memory_mib"] = 512;
    EXPECT_EQ(run_id(changed), run_id(plain));
}

TEST(RunId, KeepsTheNameThatThePapersStrategiesOnThePlainFilterHad) {
    Json before = configuration();
    before["filter"]["method"] = "paper-strategies-on-ours";
    EXPECT_EQ(identity_of(before).at("filter").at("method"), "paper");
    EXPECT_FALSE(identity_of(before).at("filter").contains("failed_match"));
    Json paper = configuration();
    paper["filter"]["method"] = "paper";
    EXPECT_NE(run_id(paper), run_id(before));
    const std::string with_default = run_id(paper);
    paper["filter"]["failed_match"]["least_score"] = 0.5;
    EXPECT_NE(run_id(paper), with_default);
}

TEST(RunId, IsTheSameForGmappingWhateverItDoesNotUse) {
    Json plain = configuration();
    plain["filter"]["method"] = "gmapping";
    Json changed = plain;
    changed["filter"]["failed_match"]["least_score"] = 0.5;
    EXPECT_EQ(run_id(changed), run_id(plain));
    for (Json* const each : {&plain, &changed}) {
        (*each)["filter"]["search"] = "coarse-fine";
    }
    EXPECT_NE(run_id(changed), run_id(plain));
}

TEST(RunId, TellsThePlainFilterFromGmappingThoughItOnceHadThatName) {
    Json plain = configuration();
    plain["filter"]["method"] = "rbpf";
    EXPECT_EQ(identity_of(plain).at("filter").at("method"), "gmapping");
    Json gmapping = configuration();
    gmapping["filter"]["method"] = "gmapping";
    EXPECT_NE(run_id(gmapping), run_id(plain));
    const std::string before = run_id(gmapping);
    for (Json* const each : {&plain, &gmapping}) {
        (*each)["filter"]["gmapping"]["update_distance_m"] = 0.625;
    }
    EXPECT_NE(run_id(gmapping), before);
    EXPECT_EQ(identity_of(plain).at("filter").dump().find("0.625"), std::string::npos);
}

TEST(RunId, OfSnapshotsIsOfTheirConfigurationAsItIs) {
    const Json snapshots{{"snapshots", "0123"}, {"format", 2}};
    EXPECT_EQ(identity_of(snapshots), snapshots);
}

}  // namespace
}  // namespace ddtool::dataset
