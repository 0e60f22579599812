#include <gmock/gmock.h>

#include <cstddef>

#include "dataset/dataset.hpp"
#include "small_dataset.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool::dataset {
namespace {

using ddtool::test::TemporaryFolder;
using ddtool::test::thrown_text;
using testing::ElementsAre;
using testing::HasSubstr;

template <typename Row>
std::string bits(std::span<const Row> rows) {
    return {bytes_of(rows).begin(), bytes_of(rows).end()};
}

/// Uses two shards, of three and of two random samples.
class StorageTest : public ::testing::Test {
protected:
    StorageTest() {
        Manifest manifest{"this build", {{"seed", 1}}, {}, {{SourceKind::world, "room"}}, {RunEntry()}, {}};
        manifest.runs[0].scene = "room";
        manifest.shards.push_back(
            test::write_drawn_shard(root_, "shard-0000", {samples_.begin(), samples_.begin() + 3}));
        manifest.shards.push_back(test::write_drawn_shard(root_, "shard-0001", {samples_.begin() + 3, samples_.end()}));
        write_manifest(root_, manifest);
    }
    [[nodiscard]] std::string opening(Check check = Check::sizes) const {
        return thrown_text([&] { const Dataset opened(root_, check); });
    }
    /// Changes one byte of a file.
    void damage(const std::string& name, std::size_t at) const {
        std::string bytes = read_file(root_ / name);
        bytes[at] = static_cast<char>(bytes[at] ^ 1);
        write_file(root_ / name, bytes);
    }

    TemporaryFolder folder_;
    std::filesystem::path root_ = folder_ / ".";
    std::vector<test::DrawnSample> samples_ = test::drawn_samples(5);
};

TEST_F(StorageTest, ThereAndBackKeepsEveryBit) {
    const Dataset read(root_, Check::checksums);
    ASSERT_EQ(read.size(), samples_.size());
    for (std::size_t index = 0; index < read.size(); ++index) {
        SampleRecord expected = samples_[index].record;
        expected.first_particle = read.sample(index).first_particle;
        EXPECT_EQ(bits(std::span(&read.sample(index), 1)), bits(std::span<const SampleRecord>(&expected, 1))) << index;
        EXPECT_EQ(bits(read.particles(index)), bits(std::span<const SnapshotParticle>(samples_[index].particles)));
    }
    EXPECT_EQ(read.run_of(read.sample(4)).scene, "room");
    EXPECT_EQ(read.manifest().settings, (Json{{"seed", 1}}));
}

TEST_F(StorageTest, ParticlesAreReadWhereTheyLie) {
    const Dataset read(root_);
    EXPECT_EQ(read.particles(1).data(), read.particles(0).data() + read.particles(0).size());
}

TEST_F(StorageTest, FindsTheSamplesOfAPart) {
    const Dataset read(root_);
    EXPECT_THAT(read.part(LabelRule::dispersion, Split::held_out, Part::test), ElementsAre(0, 1, 2, 3, 4));
    EXPECT_THAT(read.part(LabelRule::fisher, Split::paper, Part::test), ElementsAre());
}

TEST_F(StorageTest, NamesAMissingShard) {
    std::filesystem::remove(root_ / "shard-0001.particles.npy");
    EXPECT_THAT(opening(), HasSubstr("shard-0001.particles.npy: cannot read: No such file"));
}

TEST_F(StorageTest, ReadsNoShardOfAnotherFolder) {
    const std::string whole = read_file(root_ / manifest_name);
    for (const std::string& name :
         {(root_ / "shard-0001.samples.npy").string(), std::string("../shard-0001.samples.npy"),
          std::string("below/shard-0001.samples.npy"), std::string(".."), std::string()}) {
        Json wrong = Json::parse(whole);
        wrong["shards"][1]["samples"]["file"] = name;
        write_file(root_ / manifest_name, wrong.dump());
        EXPECT_THAT(opening(), HasSubstr("names '" + name + "'; expected a file of this folder"));
    }
}

TEST_F(StorageTest, NamesATruncatedShard) {
    const auto file = root_ / "shard-0000.samples.npy";
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
    EXPECT_THAT(opening(), HasSubstr("shard-0000.samples.npy: cut or damaged"));
}

TEST_F(StorageTest, NamesAShardOfAnotherDataSet) {
    test::write_drawn_shard(root_, "shard-0001", samples_);
    EXPECT_THAT(opening(), HasSubstr("shard-0001.samples.npy: 5 rows, expected 2"));
}

TEST_F(StorageTest, NamesAShardWithAWrongByteWhereChecksumsAreAskedFor) {
    for (const std::string name : {"shard-0000.samples.npy", "shard-0001.particles.npy"}) {
        const std::string whole = read_file(root_ / name);
        damage(name, whole.size() - 30);  // this byte belongs to a label or to a weight
        EXPECT_EQ(opening(Check::sizes), "") << name;
        EXPECT_THAT(opening(Check::checksums), HasSubstr(name + ": damaged: its CRC-32")) << name;
        write_file(root_ / name, whole);
    }
    EXPECT_EQ(opening(Check::checksums), "");
}

TEST_F(StorageTest, NamesAShardWhoseSamplesPointBeyondItsParticles) {
    const std::string name = "shard-0001.samples.npy";
    const std::size_t last_sample = std::filesystem::file_size(root_ / name) - sizeof(SampleRecord);
    damage(name, last_sample + offsetof(SampleRecord, first_particle) + 7);
    EXPECT_THAT(opening(), HasSubstr(name + ": damaged: a sample's particles are not in shard-0001.particles.npy"));
}

TEST_F(StorageTest, NamesAShardWhoseSamplesHaveSourcesRunsOrLabelsThatAreNone) {
    const std::string name = "shard-0001.samples.npy";
    const std::string whole = read_file(root_ / name);
    const std::size_t last_sample = whole.size() - sizeof(SampleRecord);
    const std::vector<std::pair<std::size_t, std::string>> values{
        {offsetof(SampleRecord, source) + 3, "a sample's source is not in manifest.json"},
        {offsetof(SampleRecord, run), "a sample's run is not in manifest.json"},
        {offsetof(SampleRecord, label) + 1, "a sample's label is none"}};
    for (const auto& [place, fault] : values) {
        damage(name, last_sample + place);
        EXPECT_THAT(opening(), HasSubstr(name + ": damaged: " + fault));
        write_file(root_ / name, whole);
    }
}

TEST_F(StorageTest, NamesAManifestThatContradictsItself) {
    const Json whole = Json::parse(read_file(root_ / manifest_name));
    for (const auto& [place, value] : {std::pair<const char*, Json>{"/runs/0/source", 1},
                                       {"/counts", {{"fisher", 3}}},
                                       {"/counts", {{"fisher", {{"wanted", {{"odd", 1}}}}}}}}) {
        Json changed = whole;
        changed[Json::json_pointer(place)] = value;
        write_file(root_ / manifest_name, changed.dump());
        EXPECT_THAT(opening(), HasSubstr("manifest.json: damaged")) << changed;
    }
}

TEST_F(StorageTest, WithoutAManifestThereIsNoDataSet) {
    std::filesystem::remove(root_ / manifest_name);
    EXPECT_THAT(opening(), HasSubstr("manifest.json: not there"));
}

TEST_F(StorageTest, NamesADamagedOrLaterManifest) {
    const std::string whole = read_file(root_ / manifest_name);
    write_file(root_ / manifest_name, whole.substr(0, whole.size() / 2));
    EXPECT_THAT(opening(), HasSubstr("manifest.json: damaged"));
    Json later = Json::parse(whole);
    later["ddtool_dataset"] = 3;
    write_file(root_ / manifest_name, later.dump());
    EXPECT_THAT(opening(), HasSubstr("manifest.json: version 3"));
    Json poor = Json::parse(whole);
    poor.erase("shards");
    write_file(root_ / manifest_name, poor.dump());
    EXPECT_THAT(opening(), HasSubstr("manifest.json: "));
}

}  // namespace
}  // namespace ddtool::dataset
