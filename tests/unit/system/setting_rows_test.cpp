#include "system/setting_rows.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "ddtool/base/error.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

using test::thrown_text;

struct Wheel {
    double radius_m = 0.1;
    int spokes = 8;
};

struct Cart {
    std::string name = "hay";
    Wheel wheel;
    bool driven = false;
    std::uint64_t seed = 1;
};

const SettingTable<Wheel>& wheel_rows() {
    static const SettingTable<Wheel> rows{
        {"radius_m", &Wheel::radius_m, Allowed::number(0.005, 1.0), "m", "Radius."},
        {"spokes", &Wheel::spokes, Allowed::whole(1, 1000), "", "Number of spokes.", "a wheelwright"},
    };
    return rows;
}

const SettingTable<Cart>& cart_rows() {
    static const SettingTable<Cart> rows{
        {"name", &Cart::name, Allowed::one_of({"hay", "coal"}), "", "What it carries."},
        {"wheel", &Cart::wheel, wheel_rows()},
        {"driven", &Cart::driven, Allowed::flag(), "", "Whether it drives."},
        {"seed", &Cart::seed, Allowed::seed(), "", "Seed."},
    };
    return rows;
}

std::string refusal(const std::string& path, const Json& value) {
    Json json = cart_rows().json({});
    json[Json::json_pointer(path)] = value;
    return thrown_text<UsageError>([&] { (void)cart_rows().checked(json, "cart"); });
}

TEST(SettingTable, WritesTheDefaultsInTheOrderOfItsRows) {
    EXPECT_EQ(cart_rows().json({}).dump(),
              R"({"name":"hay","wheel":{"radius_m":0.1,"spokes":8},"driven":false,"seed":1})");
}

TEST(SettingTable, ReadsWhatItWrote) {
    const Cart cart{.name = "coal", .wheel = {.radius_m = 0.5, .spokes = 1000}, .driven = true, .seed = ~0ULL};
    const Json json = cart_rows().json(cart);
    EXPECT_EQ(cart_rows().json(cart_rows().checked(json)), json);
}

TEST(SettingTable, RefusalsNameTheKeyTheRangeAndTheValue) {
    EXPECT_EQ(refusal("/wheel/spokes", 0), "cart.wheel.spokes: expected a whole number from 1 to 1000, not 0");
    EXPECT_EQ(refusal("/wheel/spokes", 2.5), "cart.wheel.spokes: expected a whole number from 1 to 1000, not 2.5");
    EXPECT_EQ(refusal("/wheel/radius_m", 0.0001),
              "cart.wheel.radius_m: expected a number from 0.005 to 1 m, not 0.0001");
    EXPECT_EQ(refusal("/name", "straw"), "cart.name: expected hay, coal, not \"straw\"");
    EXPECT_EQ(refusal("/driven", 1), "cart.driven: expected true or false, not 1");
    EXPECT_EQ(refusal("/seed", -1), "cart.seed: expected a whole number from 0 up, not -1");
    EXPECT_EQ(refusal("/wheel", 3), "cart.wheel: expected an object of settings, not 3");
}

TEST(SettingTable, RefusesWhatIsNoNumber) {
    for (const Json& value : {Json(std::numeric_limits<double>::quiet_NaN()),
                              Json(std::numeric_limits<double>::infinity()), Json("1"), Json(), Json::array({1})}) {
        EXPECT_THAT(refusal("/wheel/radius_m", value), testing::StartsWith("cart.wheel.radius_m: expected")) << value;
    }
}

TEST(SettingTable, RefusesAMissingSetting) {
    Json json = cart_rows().json({});
    json["wheel"].erase("spokes");
    EXPECT_EQ(thrown_text<UsageError>([&] { (void)cart_rows().checked(json); }),
              "wheel.spokes: this setting is missing");
}

TEST(SettingTable, TakesBothEndsOfARange) {
    EXPECT_EQ(refusal("/wheel/radius_m", 0.005), "");
    EXPECT_EQ(refusal("/wheel/radius_m", 1), "");
    EXPECT_EQ(refusal("/wheel/spokes", 1000), "");
}

TEST(SettingTable, ListsItsSettingsWithTheirPaths) {
    std::vector<std::string> paths;
    for_each_setting(without(cart_rows().settings(), "seed"),
                     [&](const std::string& path, const Setting&) { paths.push_back(path); });
    EXPECT_THAT(paths, testing::ElementsAre("name", "wheel.radius_m", "wheel.spokes", "driven"));
    EXPECT_EQ(setting_at(cart_rows().json({}), "wheel.spokes"), 8);
}

TEST(Allowed, NumbersAreNoneOrAllOfThem) {
    const Allowed pose = Allowed::numbers(3, -10.0, 10.0);
    const auto said = [&](const Json& value) {
        return thrown_text<UsageError>([&] { expect_allowed(value, pose, "m", "pose"); });
    };
    EXPECT_EQ(said(Json::array()), "");
    EXPECT_EQ(said({0.1, -2, 3}), "");
    EXPECT_EQ(said({1, 2}), "pose: expected an empty list or 3 numbers m, each from -10 to 10, not [1,2]");
    EXPECT_NE(said({1, 2, 11}), "");
    EXPECT_NE(said({1, 2, "3"}), "");
}

TEST(Allowed, AListOfNumbersHasAnyCount) {
    const Allowed codes = Allowed::numbers(0, 0.0, 1000.0);
    const auto said = [&](const Json& value) {
        return thrown_text<UsageError>([&] { expect_allowed(value, codes, "m", "no_return"); });
    };
    EXPECT_EQ(said(Json::array()), "");
    EXPECT_EQ(said({5.0}), "");
    EXPECT_EQ(said({5.0, 81.91, 0}), "");
    EXPECT_EQ(said({-1}), "no_return: expected a list of numbers m, each from 0 to 1000, not [-1]");
}

}  // namespace
}  // namespace ddtool
