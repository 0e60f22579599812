#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "thrown_text.hpp"
#include "tiny_build.hpp"

namespace ddtool::dataset {
namespace {

using ddtool::test::TemporaryFolder;
using ddtool::test::thrown_text;
using testing::HasSubstr;

class SameBytesTest : public ::testing::Test {
protected:
    SameBytesTest() { test::build_in(folder_ / "whole", settings_); }

    [[nodiscard]] std::size_t finished(const std::string& name) const {
        std::size_t count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(folder_ / (name + "/parts"))) {
            count += entry.path().extension() == ".json" ? 1U : 0U;
        }
        return count;
    }
    void expect_as_whole(const std::string& name) const {
        EXPECT_EQ(test::files_of(folder_ / name), test::files_of(folder_ / "whole"));
    }

    TemporaryFolder folder_;
    Json settings_ = test::tiny_settings(folder_);
};

TEST_F(SameBytesTest, TheWholeHasSamplesOfAllRuns) {
    const Dataset whole(folder_ / "whole");
    EXPECT_GT(whole.size(), 10U);
    ASSERT_EQ(whole.manifest().runs.size(), 8U);
    for (const RunEntry& run : whole.manifest().runs) {
        EXPECT_GT(run.candidates, 1U) << run.scene;
        EXPECT_LE(run.candidates, 4U) << run.scene;
    }
}

TEST_F(SameBytesTest, OnAnyNumberOfThreads) {
    test::build_in(folder_ / "threads", settings_, 3);
    expect_as_whole("threads");
}

TEST_F(SameBytesTest, FromOneMachineOrMany) {
    std::vector<std::string> shards;
    for (std::size_t index = 1; index <= 3; ++index) {
        shards.push_back((folder_ / ("shard" + std::to_string(index))).string());
        test::make_in(shards.back(), settings_, {index, 3});
    }
    test::merge_in(folder_ / "merged", settings_, shards);
    expect_as_whole("merged");
}

TEST_F(SameBytesTest, MergingNamesAPartThatIsMissing) {
    test::make_in(folder_ / "shard", settings_, {1, 2});
    EXPECT_THAT(thrown_text([&] { test::merge_in(folder_ / "merged", settings_, {(folder_ / "shard").string()}); }),
                HasSubstr("4 of 8 parts are missing, the first of"));
    EXPECT_THAT(thrown_text([&] { test::merge_in(folder_ / "merged", settings_, {(folder_ / "none").string()}); }),
                HasSubstr("none/parts: not there"));
}

TEST_F(SameBytesTest, AfterAKill) {
    std::filesystem::create_directories(folder_ / "cut/parts");
    const pid_t child = ::fork();
    if (child == 0) {
        test::make_in(folder_ / "cut", settings_);
        ::_exit(0);
    }
    while (finished("cut") < 2 && ::waitpid(child, nullptr, WNOHANG) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_GE(finished("cut"), 2U);
    test::build_in(folder_ / "cut", settings_);
    expect_as_whole("cut");
}

TEST_F(SameBytesTest, WhateverWasInTheFolderBefore) {
    Json other = settings_;
    other["balance"]["degenerate"] = 1U;
    test::build_in(folder_ / "older", other);
    write_file(folder_ / "older/shard-0007.samples.npy", "left behind");
    test::build_in(folder_ / "older", settings_);
    expect_as_whole("older");
}

/// What the function writes on stderr.
template <typename Function>
std::string said_by(const Function& function) {
    testing::internal::CaptureStderr();
    function();
    return testing::internal::GetCapturedStderr();
}

TEST_F(SameBytesTest, ADamagedPartIsNamedAndMadeAnew) {
    const auto results = test::make_in(folder_ / "whole", settings_);
    const auto file = results[1].value->folder / results[1].value->shard.particles.file;
    const std::string whole = read_file(file);
    std::string bytes = whole;
    bytes[bytes.size() - 3] = static_cast<char>(bytes[bytes.size() - 3] ^ 1);
    write_file(file, bytes);
    const std::string said = said_by([&] { test::build_in(folder_ / "again", settings_); });
    EXPECT_THAT(said, Not(HasSubstr("damaged")));
    EXPECT_THAT(said_by([&] { test::build_in(folder_ / "whole", settings_); }),
                HasSubstr(results[1].value->shard.particles.file + ": damaged"));
    EXPECT_EQ(read_file(file), whole);
    expect_as_whole("again");
}

TEST_F(SameBytesTest, MergingTakesADamagedPartForAMissingOne) {
    const auto results = test::make_in(folder_ / "whole", settings_);
    write_file(results[1].value->folder / results[1].value->shard.samples.file, "no rows");
    EXPECT_THAT(thrown_text([&] { test::merge_in(folder_ / "whole", settings_, {}); }),
                HasSubstr("1 of 8 parts are missing, the first of"));
}

TEST_F(SameBytesTest, ADescriptionThatLacksSomethingIsNamedInOneLine) {
    const auto results = test::make_in(folder_ / "whole", settings_);
    const PlannedRun run = plan_runs(settings_).runs[1];
    const auto file = results[1].value->folder / (run.entry.id + ".json");
    const Json whole = Json::parse(read_file(file));
    std::vector<Json> damaged{Json{{"configuration", run.key.configuration()}}};  // a file without any part
    for (const auto& [key, value] : whole.at("part").items()) {
        Json without = whole;
        without["part"].erase(key);
        damaged.push_back(without);
        Json other_type = whole;
        other_type["part"][key] = Json::array({"?"});
        damaged.push_back(other_type);
    }
    const PartStore store(folder_ / "whole", {});
    EXPECT_TRUE(store.find(run));
    for (const Json& json : damaged) {
        write_file(file, json.dump());
        const std::string text = said_by([&] { EXPECT_FALSE(store.find(run)); });
        EXPECT_THAT(text, HasSubstr(file.string() + ": damaged, so it counts as missing")) << json.dump(1);
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    }
}

}  // namespace
}  // namespace ddtool::dataset
