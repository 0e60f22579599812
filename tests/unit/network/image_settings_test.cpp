#include "ddtool/network/image_settings.hpp"

#include <gmock/gmock.h>

#include "thrown_text.hpp"

namespace ddtool {
namespace {

using test::thrown_text;
using testing::HasSubstr;

TEST(ImageSettings, SurviveTheWayThroughJson) {
    ImageSettings settings;
    settings.swarm = Swarm::step;
    settings.size_px = 64;
    settings.linear_mapping = false;
    const Json json = settings;
    EXPECT_EQ(json.at("swarm"), "step");
    EXPECT_EQ(Json(json.get<ImageSettings>()), json);
}

TEST(ImageSettings, RefuseAnUnknownSwarm) {
    Json json = ImageSettings{};
    json["swarm"] = "relative";
    EXPECT_THAT(thrown_text<UsageError>([&] { json.get<ImageSettings>(); }), HasSubstr("absolute, step or response"));
}

TEST(ImageSettings, NameTheOneThatMakesNoSense) {
    expect_valid({});
    for (const char* key : {"size_px", "canvas_m", "step_canvas_min_m", "gaussian_sigma_px", "gaussian_threshold"}) {
        Json json = ImageSettings{};
        json[key] = 0;
        EXPECT_THAT(thrown_text<UsageError>([&] { expect_valid(json.get<ImageSettings>()); }), HasSubstr(key));
    }
    EXPECT_THAT(thrown_text<UsageError>([] { expect_valid({.step_canvas_spreads = -1.0}); }),
                HasSubstr("step_canvas_spreads"));
}

}  // namespace
}  // namespace ddtool
