#include "train/history.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"
#include "train/event_file.hpp"

namespace ddtool::train {
namespace {

using ddtool::test::TemporaryFolder;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::array<const char*, 4> files{"metrics.csv", "metrics.json", "curves.png", event_file_name};

std::vector<EpochRecord> epochs_of(std::size_t count, double loss = 0.7) {
    std::vector<EpochRecord> epochs;
    for (std::uint64_t epoch = 1; epoch <= count; ++epoch) {
        const auto number = static_cast<double>(epoch);
        epochs.push_back({epoch, 1e-3 / number, loss / number, 0.9, 0.8 / number, 0.85, 0.8, 0.95, 3.0, 1e9 + number});
    }
    return epochs;
}

/// The file's inode, which differs from that of another file under the same name.
ino_t inode_of(const std::filesystem::path& file) {
    struct stat status {};
    return ::stat(file.c_str(), &status) == 0 ? status.st_ino : 0;
}

TEST(History, TellsTheEpochsAsTheyWere) {
    const TemporaryFolder folder;
    const std::vector<EpochRecord> epochs = epochs_of(3);
    write_history(folder / "run", epochs);
    EXPECT_EQ(Json::parse(read_file(folder / "run/metrics.json")).get<std::vector<EpochRecord>>(), epochs);
    const std::string csv = read_file(folder / "run/metrics.csv");
    EXPECT_THAT(csv, StartsWith("epoch,learning_rate,train_loss,"));
    EXPECT_THAT(csv, HasSubstr("\n2,5e-04,0.35,0.9,0.4,0.85,0.8,0.95,3,1000000002\n"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
}

TEST(History, IsTheSameWrittenOnceOrAfterEveryEpoch) {
    const TemporaryFolder folder;
    write_history(folder / "once", epochs_of(4));
    for (const std::size_t count : {0U, 1U, 2U, 4U}) {
        write_history(folder / "often", epochs_of(count));
    }
    write_history(folder / "longer", epochs_of(6));
    write_history(folder / "longer", epochs_of(4));
    for (const std::string file : files) {
        EXPECT_EQ(read_file(folder / "often" / file), read_file(folder / "once" / file)) << file;
        EXPECT_EQ(read_file(folder / "longer" / file), read_file(folder / "once" / file)) << file;
    }
}

TEST(History, WritesWhatIsNotANumber) {
    const TemporaryFolder folder;
    std::vector<EpochRecord> epochs = epochs_of(2);
    epochs[1].validation_auc = std::nan("");
    write_history(folder / "run", epochs);
    EXPECT_THAT(read_file(folder / "run/metrics.csv"), HasSubstr(",0.8,,3,1000000002\n"));
    EXPECT_TRUE(Json::parse(read_file(folder / "run/metrics.json"))[1]["validation_auc"].is_null());
}

TEST(EventFile, IsLengthenedInPlaceForWhoeverHasItOpen) {
    const TemporaryFolder folder;
    const auto file = folder / "events.out.tfevents.test";
    const std::vector<StepScalars> steps{{1.0, 1, {{"loss", 0.5}}}, {2.0, 2, {{"loss", 0.25}}}, {3.0, 3, {}}};
    write_event_file(file, std::span(steps).first(1));
    const ino_t first = inode_of(file);
    write_event_file(file, std::span(steps).first(2));
    write_event_file(file, steps);
    EXPECT_EQ(inode_of(file), first);
    EXPECT_EQ(read_file(file), event_file_of(steps));
    std::vector<StepScalars> others = steps;
    others[0].values[0].second = 0.75;
    write_event_file(file, others);
    EXPECT_EQ(read_file(file), event_file_of(others));
}

TEST(EventFile, MendsARecordThatWasCutShort) {
    const TemporaryFolder folder;
    const auto file = folder / "events.out.tfevents.test";
    const std::vector<StepScalars> steps{{1.0, 1, {{"loss", 0.5}}}, {2.0, 2, {{"loss", 0.25}}}};
    const std::string whole = event_file_of(steps);
    for (const std::size_t length : {std::size_t{0}, std::size_t{5}, whole.size() - 1, whole.size()}) {
        write_file(file, whole.substr(0, length));
        write_event_file(file, steps);
        EXPECT_EQ(read_file(file), whole) << length;
    }
}

TEST(History, NamesTheFileThatCannotBeWritten) {
    const TemporaryFolder folder;
    for (const std::string file : files) {
        std::filesystem::create_directories(folder / "run" / file / "in the way");
        EXPECT_THAT(ddtool::test::thrown_text([&] { write_history(folder / "run", epochs_of(1)); }), HasSubstr(file));
        std::filesystem::remove_all(folder / "run" / file);
    }
}

}  // namespace
}  // namespace ddtool::train
