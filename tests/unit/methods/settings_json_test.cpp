#include "methods/settings_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <type_traits>

#include "thrown_text.hpp"

namespace ddtool {
namespace {

/// Converts to any type, and so stands for any field of an aggregate.
struct AnyField {
    template <typename Field>
    operator Field() const;  // NOLINT(google-explicit-constructor)
};

/// The number of fields of an aggregate: the largest number of values with which it can be initialised.
template <typename Struct, typename... Fields>
constexpr std::size_t field_count() {
    if constexpr (requires { Struct{Fields{}..., AnyField{}}; }) {
        return field_count<Struct, Fields..., AnyField>();
    } else {
        return sizeof...(Fields);
    }
}

TEST(FilterSettings, LeaveNoFieldOut) {
    const Json json = filter_settings_json({});
    // In the JSON, the names of the parts are members beside the filter's own settings, where MethodSettings has all of
    // them in one field, and so is the group "gmapping".
    EXPECT_EQ(json.size(), field_count<RbpfSettings>() + field_count<MethodParts>() + field_count<MethodSettings>());
    constexpr std::size_t common = 4;  // particles, seed, grid and points, which the filter's own settings have
    EXPECT_EQ(json.at("gmapping").size(), field_count<GmappingSettings>() - common);
    EXPECT_EQ(json.at("gmapping").at("motion").size(), field_count<LinearMotionNoise>());
    EXPECT_EQ(json.at("gmapping").at("matcher").size(), field_count<HillClimbSettings>());
    EXPECT_EQ(json.at("detection").size(), field_count<DetectionSettings>());
    EXPECT_EQ(json.at("coarse_fine").size(), field_count<CoarseFineSettings>());
    EXPECT_EQ(json.at("correlative").size(), field_count<CorrelativeSearchSettings>());
    EXPECT_EQ(json.at("fusion").size(), field_count<FusionSettings>());
    EXPECT_EQ(json.at("eigenvalue_gate").size(), field_count<EigenvalueGateSettings>());
    EXPECT_EQ(json.at("enhanced_resampling").size(), field_count<EnhancedResamplingSettings>());
    EXPECT_EQ(json.at("motion").size(), field_count<MotionNoise>());
    EXPECT_EQ(json.at("grid").size(), field_count<OccupancySettings>());
    EXPECT_EQ(json.at("points").size(), field_count<ScanPointsSettings>());
    EXPECT_EQ(json.at("matcher").size(), field_count<ScanMatcherSettings>());
}

/// A settings tree in which every number is a little larger and every flag turned, so that none has its default. Names
/// are not changed, because each of them must be in a table.
Json enlarged(Json json) {
    for (auto& [key, value] : json.items()) {
        if (value.is_object()) {
            value = enlarged(value);
        } else if (value.is_string()) {
            continue;
        } else if (value.is_boolean()) {
            value = !value.get<bool>();
        } else if (value.is_number_integer()) {
            value = value.get<int>() + 1;
        } else {
            value = value.get<double>() * 1.25;
        }
    }
    return json;
}

TEST(FilterSettings, ComeBackFromJson) {
    const Json json = enlarged(filter_settings_json({}));
    EXPECT_EQ(filter_settings_json(filter_settings_from_json(json)), json);
}

TEST(FilterSettings, ThatMakeNoSenseAreNamed) {
    const auto refusal = [](const std::string& path, const Json& value) {
        Json json = filter_settings_json({});
        json[Json::json_pointer(path)] = value;
        return test::thrown_text<UsageError>([&] { filter_settings_from_json(json); });
    };
    EXPECT_THAT(refusal("/particles", 0), testing::HasSubstr("filter.particles: expected"));
    EXPECT_THAT(refusal("/particles", -1), testing::HasSubstr("not -1"));
    EXPECT_THAT(refusal("/seed", -1), testing::HasSubstr("filter.seed"));
    EXPECT_THAT(refusal("/update_distance_m", 0.0), testing::HasSubstr("filter.update_distance_m"));
    EXPECT_THAT(refusal("/grid/cell_size_m", -0.05), testing::HasSubstr("filter.grid.cell_size_m"));
    EXPECT_THAT(refusal("/grid/max_log_odds", 200), testing::HasSubstr("filter.grid.max_log_odds"));
}

}  // namespace
}  // namespace ddtool
