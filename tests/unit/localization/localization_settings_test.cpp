#include "localization/localization_settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "thrown_text.hpp"

namespace ddtool::localization {
namespace {

TEST(LocalizationSettings, AreReadFromTheirJson) {
    Json json = default_localization_json();
    json["filter"]["particles"] = 40;
    json["localization"]["most_particles"] = 80;
    const LocalizationSettings settings = localization_from_json(json);
    EXPECT_EQ(settings.particles.least_particles, 40U);
    EXPECT_EQ(settings.particles.most_particles, 80U);
}

TEST(LocalizationSettings, EverySettingIsDescribed) {
    const Json json = default_localization_json();
    std::size_t described = 0;
    for_each_setting(localization_setting_list(), [&](const std::string& path, const Setting&) {
        ++described;
        EXPECT_NO_THROW(setting_at(json, path)) << path;
    });
    EXPECT_GT(described, 30U);
}

TEST(LocalizationSettings, WhatCannotBeIsRefused) {
    Json json = default_localization_json();
    json["localization"]["most_particles"] = 10;
    EXPECT_THAT(ddtool::test::thrown_text([&] { localization_from_json(json); }),
                testing::HasSubstr("at least filter.particles"));
    json = default_localization_json();
    json["filter"]["likelihood_gain"] = 0.0;
    EXPECT_THAT(ddtool::test::thrown_text([&] { localization_from_json(json); }),
                testing::HasSubstr("likelihood_gain"));
}

}  // namespace
}  // namespace ddtool::localization
