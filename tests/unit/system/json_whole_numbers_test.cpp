#include "ddtool/system/json_whole_numbers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ddtool/system/json_struct.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

struct Counted {
    std::size_t count = 0;
    std::int8_t small = 0;
    std::vector<std::int64_t> list;
    double number = 0.0;
    bool flag = false;
};
DDTOOL_JSON_STRUCT(Counted, count, small, list, number, flag)

Json counted(const char* key, const Json& value) {
    Json json = Counted();
    json[key] = value;
    return json;
}

TEST(JsonWholeNumbers, ThereAndBackUpToTheirLimits) {
    const Counted most{.count = SIZE_MAX, .small = INT8_MIN, .list = {INT64_MIN, INT64_MAX}, .number = 3, .flag = true};
    const auto read = Json::parse(Json(most).dump()).get<Counted>();
    EXPECT_EQ(Json(read), Json(most));
    EXPECT_EQ(read.count, SIZE_MAX);
    EXPECT_EQ(counted("number", 7).get<Counted>().number, 7.0) << "a whole number is a number";
}

TEST(JsonWholeNumbers, AreReadFromNothingElse) {
    const auto refusal = [](const char* key, const Json& value) {
        return test::thrown_text<Json::type_error>([&] { (void)counted(key, value).get<Counted>(); });
    };
    EXPECT_THAT(refusal("count", -1),
                testing::EndsWith("expected a whole number from 0 to 18446744073709551615, not -1"));
    EXPECT_THAT(refusal("count", 1e30), testing::HasSubstr("not 1e+30"));
    EXPECT_THAT(refusal("count", "3"), testing::HasSubstr("expected a whole number"));
    EXPECT_THAT(refusal("count", nullptr), testing::HasSubstr("expected a whole number"));
    EXPECT_THAT(refusal("count", true), testing::HasSubstr("expected a whole number"));
    EXPECT_THAT(refusal("small", 128), testing::EndsWith("from -128 to 127, not 128"));
    EXPECT_THAT(refusal("list", Json::array({1, 1.5})), testing::HasSubstr("not 1.5"));
}

}  // namespace
}  // namespace ddtool
