#include "ddtool/system/settings.hpp"

#include <gmock/gmock.h>

#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

using test::TemporaryFolder;
using test::thrown_text;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

Json example() {
    return {{"seed", 1U},
            {"method", "gmapping"},
            {"filter", {{"particles", 30}, {"sigma_m", 1.0}, {"adaptive", false}}},
            {"laser_pose", {0.0, 0.0, 0.0}},
            {"limit", nullptr}};
}

Json with(const std::string& assignment) {
    Json settings = example();
    merge_assignment(settings, assignment);
    return settings;
}

std::string refusal(const std::string& assignment) {
    return thrown_text<UsageError>([&] { with(assignment); });
}

TEST(Settings, AssignmentChangesThatValueAlone) {
    Json expected = example();
    expected["filter"]["particles"] = 60;
    EXPECT_EQ(with("filter.particles=60"), expected);
    EXPECT_EQ(with("filter.adaptive=true")["filter"]["adaptive"], true);
    EXPECT_EQ(with("filter={\"particles\":60}"), expected);
}

TEST(Settings, MergingTheDefaultsChangesNothing) {
    Json settings = example();
    merge_settings(settings, example(), "test");
    EXPECT_EQ(settings.dump(), example().dump());
}

TEST(Settings, TextIsTakenAsItIs) {
    for (const std::string text : {"a=b", "true", "12", "\"quoted\"", "null", "", "[x", "with blanks"}) {
        EXPECT_EQ(with("method=" + text)["method"], text);
    }
}

TEST(Settings, ListMayLeaveOutItsBrackets) {
    EXPECT_EQ(with("laser_pose=0.1,-2,3"), with("laser_pose=[0.1,-2,3]"));
    EXPECT_EQ(with("laser_pose=0.1"), with("laser_pose=[0.1]"));
    EXPECT_THAT(refusal("laser_pose=[1,\"a\"]"), HasSubstr("'laser_pose'"));
}

TEST(Settings, FloatStaysAFloat) {
    Json settings = with("filter.sigma_m=2");
    merge_assignment(settings, "filter.sigma_m=0.5");
    EXPECT_EQ(settings["filter"]["sigma_m"], 0.5);
}

TEST(Settings, NullTakesAnyValue) { EXPECT_EQ(with("limit=3.5")["limit"], 3.5); }

TEST(Settings, WrongTypeNamesSourceKeyValueAndWhatWasExpected) {
    EXPECT_EQ(refusal("filter.particles=many"),
              "--set: setting 'filter.particles' is \"many\", expected whole number such as 30");
    EXPECT_THAT(refusal("filter.particles=1.5"), HasSubstr("whole number"));
    EXPECT_THAT(refusal("seed=-1"), HasSubstr("from 0 up"));
    EXPECT_EQ(with("seed=18446744073709551615")["seed"], 18446744073709551615U);
    EXPECT_THAT(refusal("filter=3"), HasSubstr("'filter'"));
    EXPECT_THAT(refusal("filter.adaptive=1"), HasSubstr("boolean"));
}

TEST(Settings, UnknownKeyNamesTheNearestKnown) {
    EXPECT_THAT(refusal("filter.partcles=3"), HasSubstr("did you mean: filter.particles"));
    EXPECT_THAT(refusal("particles=3"), HasSubstr("did you mean: filter.particles"));
    EXPECT_THAT(refusal("seed.x=3"), HasSubstr("'seed'"));
    Json none = Json::object();
    EXPECT_THAT(thrown_text<UsageError>([&] { merge_assignment(none, "a=1"); }), HasSubstr("there are no settings"));
}

TEST(Settings, OddPathsAreUnknownKeysNotCrashes) {
    for (const std::string path : {"0", "a~b", "a/b", ".", "filter..x", "filter.", "~"}) {
        EXPECT_NE(refusal(path + "=1"), "") << path;
    }
    EXPECT_THAT(refusal("seed"), HasSubstr("path.to.key=value"));
    EXPECT_THAT(refusal("=1"), HasSubstr("path.to.key=value"));
}

TEST(Settings, FileMayHoldCommentsAndIsNamedInErrors) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "a.json";
    const auto merged = [&](const std::string& content) {
        write_file(file, content);
        Json settings = example();
        merge_settings_file(settings, file);
        return settings;
    };
    EXPECT_EQ(merged("{\"seed\": 5} // the fifth")["seed"], 5);
    EXPECT_THAT(thrown_text<UsageError>([&] { merged("{\n\"seed\": 5,\n]"); }), HasSubstr("a.json:3: expected JSON"));
    EXPECT_THAT(thrown_text<UsageError>([&] { merged("[1]"); }), HasSubstr("a.json: expected a JSON object"));
    EXPECT_THAT(thrown_text<UsageError>([&] { merged("{\"sed\": 5}"); }),
                AllOf(HasSubstr("a.json"), HasSubstr("'sed'"), HasSubstr("seed")));
    const auto nested = [](std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
    EXPECT_TRUE(merged("{\"limit\": " + nested(99) + "}")["limit"].is_array());
    EXPECT_THAT(thrown_text<UsageError>([&] { merged("{\"limit\": " + nested(100'000) + "}"); }),
                HasSubstr("a.json: nested deeper than 100 levels"));
    Json settings = example();
    EXPECT_THAT(thrown_text<UsageError>([&] { merge_settings_file(settings, folder / "none.json"); }),
                HasSubstr("none.json: cannot read: No such file"));
}

TEST(NearestWords, ComesInOrderOfDistance) {
    EXPECT_THAT(nearest_words("slma", {"convert", "score", "slam", "simulate"}), testing::Contains("slam"));
    EXPECT_THAT(nearest_words("b", {"abc", "b", "ab", "abcd"}), ElementsAre("b", "ab", "abc"));
    EXPECT_THAT(nearest_words("x", {}), ElementsAre());
}

}  // namespace
}  // namespace ddtool
