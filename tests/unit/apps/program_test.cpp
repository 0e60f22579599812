#include "program.hpp"

#include <gmock/gmock.h>

#include "system/atomic_file.hpp"
#include "system/log.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"
#include "version.hpp"

namespace ddtool {
namespace {

using test::thrown_text;
using testing::HasSubstr;

/// A command that copies the settings it is run with into `seen`, and the chosen group of settings into `kind`.
Command probe(Json& seen, std::string& kind) {
    return {
        .name = "probe",
        .summary = "Shows its settings",
        .example = "ddtool probe --particles 5",
        .settings = {{"filter", {{"particles", 30}}}, {"method", "m"}, {"fast", true}, {"laser_pose", {0.0, 0.0, 0.0}}},
        .options = {{"--kind",
                     NamedSettings{{{"usual", Json::object()}, {"large", {{"filter", {{"particles", 500}}}}}}, &kind},
                     "What kind"},
                    {"--particles", SettingPath{"filter.particles"}, "How many"},
                    {"--method", SettingPath{"method"}, "Which"},
                    {"--fast", SettingPath{"fast"}, "Whether"},
                    {"--laser-pose", SettingPath{"laser_pose"}, "Where"}},
        .run = [&seen](const Json& settings) {
            seen = settings;
            return ExitCode::done_with_loss;
        }};
}

struct Outcome {
    ExitCode code = ExitCode::done;
    Json settings;
    std::string kind = "usual";
    std::string out;
};

Outcome outcome(std::vector<const char*> words) {
    Outcome result;
    const CommandTable commands{probe(result.settings, result.kind)};
    words.insert(words.begin(), "ddtool");
    testing::internal::CaptureStdout();
    try {
        result.code = run_program(commands, static_cast<int>(words.size()), words.data());
    } catch (...) {
        testing::internal::GetCapturedStdout();
        throw;
    }
    result.out = testing::internal::GetCapturedStdout();
    return result;
}

std::string refusal(const std::vector<const char*>& words) {
    return thrown_text<UsageError>([&] { outcome(words); });
}

TEST(Program, RunsTheChosenCommandWithItsDefaultsAndReturnsItsCode) {
    const Outcome result = outcome({"probe"});
    EXPECT_EQ(result.code, ExitCode::done_with_loss);
    EXPECT_EQ(result.settings["filter"]["particles"], 30);
}

TEST(Program, BoundOptionIsTheSettingItStandsFor) {
    EXPECT_EQ(outcome({"probe", "--particles", "60"}).settings,
              outcome({"probe", "--set", "filter.particles=60"}).settings);
    EXPECT_EQ(outcome({"probe", "--laser-pose", "-0.1,0,3"}).settings,
              outcome({"probe", "--set", "laser_pose=[-0.1,0,3]"}).settings);
}

TEST(Program, NamedGroupOfSettingsComesBeforeAllOtherChanges) {
    const Outcome result = outcome({"probe", "--kind", "large"});
    EXPECT_EQ(result.settings["filter"]["particles"], 500);
    EXPECT_EQ(result.kind, "large");
    EXPECT_EQ(outcome({"probe", "--set", "filter.particles=60", "--kind", "large"}).settings["filter"]["particles"],
              60);
    EXPECT_EQ(outcome({"probe"}).kind, "usual");
    EXPECT_EQ(refusal({"probe", "--kind", "huge"}), "--kind: expected usual, large, not 'huge'");
}

TEST(Program, BoundTextIsTakenAsItIs) {
    for (const char* text : {"a=b", "12", "true", "with blanks", "\"q\""}) {
        EXPECT_EQ(outcome({"probe", "--method", text}).settings["method"], text);
    }
}

TEST(Program, BoundBooleanIsAFlagWithATwin) {
    EXPECT_EQ(outcome({"probe", "--no-fast"}).settings["fast"], false);
    EXPECT_EQ(outcome({"probe", "--set", "fast=false", "--fast"}).settings["fast"], true);
}

TEST(Program, LaterSettingWins) {
    EXPECT_EQ(outcome({"probe", "--set", "filter.particles=1", "--set", "filter.particles=2"})
                  .settings["filter"]["particles"],
              2);
    EXPECT_EQ(outcome({"probe", "--particles", "3", "--set", "filter.particles=2"}).settings["filter"]["particles"], 3);
}

TEST(Program, BoundOptionIsNamedInErrors) {
    EXPECT_THAT(refusal({"probe", "--particles", "many"}), testing::StartsWith("--particles: setting"));
}

TEST(Program, UnknownWordsNameTheNearest) {
    EXPECT_EQ(refusal({"prbe"}), "unknown command 'prbe'; did you mean: probe?");
    EXPECT_THAT(refusal({"probe", "--partcles", "3"}),
                testing::AllOf(HasSubstr("'--partcles'"), HasSubstr("--particles")));
    EXPECT_THAT(refusal({"probe", "stray"}), HasSubstr("unexpected argument 'stray'"));
    EXPECT_THAT(refusal({}), HasSubstr("expected a command"));
    EXPECT_NE(refusal({"probe", "--particles"}), "");
}

TEST(Program, SharedOptionsMayStandOnEitherSideOfTheCommand) {
    for (const std::vector<const char*>& words : {std::vector<const char*>{"--quiet", "probe"}, {"probe", "--quiet"}}) {
        set_log_level(LogLevel::info);
        outcome(words);
        EXPECT_FALSE(log_shows(LogLevel::warning));
        EXPECT_TRUE(log_shows(LogLevel::error));
    }
    outcome({"probe", "--log-level", "debug"});
    EXPECT_TRUE(log_shows(LogLevel::debug));
    EXPECT_THAT(refusal({"--log-level", "loud", "probe"}), HasSubstr("'loud'"));
    set_log_level(LogLevel::info);
}

TEST(Program, HelpShowsDefaultsAndAnExampleAndRunsNothing) {
    const Outcome result = outcome({"probe", "--help"});
    EXPECT_EQ(result.code, ExitCode::done);
    EXPECT_TRUE(result.settings.is_null());
    EXPECT_THAT(result.out, HasSubstr("ddtool probe --particles 5"));
    EXPECT_THAT(result.out, HasSubstr("INT=30"));
}

TEST(Program, BuiltinPlanLiesUnderTheUsersSettingsWhereTheyHaveNone) {
    Json seen;
    std::string kind;
    Command command = probe(seen, kind);
    command.plan = BuiltinPlan{"plans/usual.json", R"({"method": "planned", "filter": {"particles": 7}} // why)",
                               [](const Json& settings) { return settings.at("method") == "m"; }};
    const CommandTable commands{std::move(command)};
    const auto settings_of = [&](std::vector<const char*> words) {
        words.insert(words.begin(), {"ddtool", "--quiet", "probe"});
        run_program(commands, static_cast<int>(words.size()), words.data());
        return seen;
    };
    EXPECT_EQ(settings_of({})["method"], "planned");
    EXPECT_EQ(settings_of({})["fast"], true);
    const Json changed = settings_of({"--set", "filter.particles=2"});
    EXPECT_EQ(changed["method"], "planned");
    EXPECT_EQ(changed["filter"]["particles"], 2);
    const Json own = settings_of({"--method", "own"});
    EXPECT_EQ(own["method"], "own");
    EXPECT_EQ(own["filter"]["particles"], 30);
    const test::TemporaryFolder folder;
    write_file(folder / "empty.json", "{}");
    EXPECT_EQ(settings_of({"--config", (folder / "empty.json").c_str()})["method"], "m");
    set_log_level(LogLevel::info);
}

TEST(Program, VersionNamesTheCommitAndTheLibraries) {
    const std::string out = outcome({"--version"}).out;
    for (const std::string name : {"ddtool", "commit", "compiler", "CLI11", "Eigen", "fast-cdr", "LibTorch", "lz4",
                                   "nlohmann-json", "OpenCV", "protobuf", "spdlog", "zstd"}) {
        EXPECT_THAT(out, HasSubstr(name));
    }
    EXPECT_EQ(out, version_text() + "\n");
}

TEST(Program, AnOptionMayTakeTheRestOfTheLineUpToTwoDashes) {
    std::vector<std::string> rest;
    std::string out;
    const CommandTable commands{
        {.name = "drive",
         .summary = "Takes words",
         .example = "ddtool drive",
         .options = {{.name = "--ros-args", .value = &rest, .help = "Words", .takes_rest = true},
                     {.name = "--out", .value = &out, .help = "Where"}},
         .run = [](const Json&) { return ExitCode::done; }}};
    const std::vector<const char*> words{"ddtool",  "drive", "--ros-args", "-r",    "a:=/b",
                                         "--param", "c:=1",  "--",         "--out", "folder"};
    EXPECT_EQ(run_program(commands, static_cast<int>(words.size()), words.data()), ExitCode::done);
    EXPECT_THAT(rest, testing::ElementsAre("-r", "a:=/b", "--param", "c:=1"));
    EXPECT_EQ(out, "folder");
}

}  // namespace
}  // namespace ddtool
