#include "assumed_inputs.hpp"

#include <gmock/gmock.h>

#include "ddtool/base/error.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

using test::TemporaryFolder;

/// Writes the file so many seconds after the others with a smaller number.
void write_at(const std::filesystem::path& file, int time_s) {
    std::filesystem::create_directories(file.parent_path());
    write_file(file, "");
    std::filesystem::last_write_time(file, std::filesystem::file_time_type(std::chrono::seconds(time_s)));
}

TEST(NewestModel, IsTheCheckpointOrExportedModelThatWasWrittenLast) {
    const TemporaryFolder folder;
    EXPECT_EQ(newest_model_in(folder / "."), std::nullopt);
    write_at(folder / "train/best.pt", 2);
    write_at(folder / "train-2/best.pt", 1);
    EXPECT_EQ(newest_model_in(folder / ""), folder / "train/best.pt");
    write_at(folder / "exported.pt", 3);
    EXPECT_EQ(newest_model_in(folder / ""), folder / "exported.pt");
    write_at(folder / "train-3/best.pt", 4);
    EXPECT_EQ(newest_model_in(folder / ""), folder / "train-3/best.pt");
}

TEST(NewestModel, IsNoCheckpointOfAnUnfinishedEpochAndNothingDeeper) {
    const TemporaryFolder folder;
    write_at(folder / "train/last.pt", 1);
    write_at(folder / "ablation/models/best.pt", 2);
    write_at(folder / "dataset/manifest.json", 3);
    EXPECT_EQ(newest_model_in(folder / ""), std::nullopt);
    EXPECT_EQ(newest_model_in(folder / "none"), std::nullopt);
}

TEST(DataFolder, SaysHowToMakeTheOneThatIsAssumed) {
    const TemporaryFolder folder;
    const std::string missing = folder / "dataset";
    EXPECT_EQ(data_folder(missing, true), missing) << "whoever reads it says what is missing";
    EXPECT_THAT(test::thrown_text([&] { data_folder(missing, false); }), testing::HasSubstr("ddtool build-dataset"));
    EXPECT_EQ(data_folder(folder / "", false), folder / "");
}

}  // namespace
}  // namespace ddtool
