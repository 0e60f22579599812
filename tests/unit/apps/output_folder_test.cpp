#include "output_folder.hpp"

#include <gmock/gmock.h>

#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

class OutputFolderTest : public testing::Test {
protected:
    /// The name that a command without --out would choose, relative to the test's folder. Something is written to it,
    /// so that it stays.
    std::string chosen(const std::string& name, const OutputFolder::Unfinished& unfinished = {}) {
        const OutputFolder output("", (folder_ / name).string(), unfinished);
        EXPECT_TRUE(std::filesystem::is_directory(output.path()));
        write_file(output.path() / "result", "");
        return output.path().filename();
    }

    TemporaryFolder folder_;
};

TEST_F(OutputFolderTest, TakesTheFirstNameThatNothingHas) {
    EXPECT_EQ(chosen("run"), "run");
    EXPECT_EQ(chosen("run"), "run-2");
    EXPECT_EQ(chosen("run"), "run-3");
    std::filesystem::remove_all(folder_ / "run-2");
    EXPECT_EQ(chosen("run"), "run-2");
}

TEST_F(OutputFolderTest, FilesAndLinksCountAsTaken) {
    write_file(folder_ / "run", "a file");
    std::filesystem::create_symlink("nowhere", folder_ / "run-2");
    EXPECT_EQ(chosen("run"), "run-3");
    EXPECT_EQ(read_file(folder_ / "run"), "a file");
}

TEST_F(OutputFolderTest, OneThatIsGivenIsTakenAsItIs) {
    EXPECT_EQ(OutputFolder("given/below", "run").path(), "given/below");
    EXPECT_FALSE(std::filesystem::exists("given"));
}

TEST_F(OutputFolderTest, ANewOneInWhichNothingWasWrittenIsRemoved) {
    { const OutputFolder output("", (folder_ / "run").string()); }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "run"));
}

TEST_F(OutputFolderTest, GoesOnInTheFirstThatIsUnfinished) {
    for (const char* name : {"run", "run-2", "run-3"}) {
        EXPECT_EQ(chosen("run"), name);
    }
    const auto unfinished = [](const std::filesystem::path& folder) { return folder.filename() != "run"; };
    EXPECT_EQ(chosen("run", unfinished), "run-2");
    EXPECT_EQ(chosen("run", [](const std::filesystem::path&) { return false; }), "run-4");
}

TEST_F(OutputFolderTest, TellsTheReasonWhereNoneCanBeMade) {
    EXPECT_THAT(test::thrown_text<OutputError>([&] { OutputFolder("", (folder_ / "none/run").string()); }),
                HasSubstr("none/run: cannot create the folder: No such file"));
}

TEST(NameOfResults, IsThatOfTheLogWithoutFolderAndEnding) {
    EXPECT_EQ(name_of_results("run.mcap"), "run");
    EXPECT_EQ(name_of_results("/logs/of/run.2.bag"), "run.2");
    EXPECT_EQ(name_of_results("intel.clf.bz2"), "intel");
    EXPECT_EQ(name_of_results("intel.clf.gz"), "intel");
    EXPECT_EQ(name_of_results("run_0.db3.zstd"), "run_0");
    EXPECT_EQ(name_of_results("run.tar.gz"), "run");
    EXPECT_EQ(name_of_results("recording/metadata.yaml"), "recording");
    EXPECT_EQ(name_of_results("run"), "run");
}

TEST(NameOfResults, OfAFolderIsItsName) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "drive.of.may");
    EXPECT_EQ(name_of_results(folder / "drive.of.may"), "drive.of.may");
    EXPECT_EQ(name_of_results(folder / "drive.of.may/"), "drive.of.may");
}

TEST(NameOfResults, IsSlamWhereTheLogHasNone) {
    for (const char* log : {"-", ".", "..", "../..", "/", ""}) {
        EXPECT_EQ(name_of_results(log), "slam") << log;
    }
}

}  // namespace
}  // namespace ddtool
