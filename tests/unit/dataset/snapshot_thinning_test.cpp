#include "dataset/snapshot_thinning.hpp"

#include <gmock/gmock.h>

#include <set>

namespace ddtool::dataset {
namespace {

std::vector<std::uint64_t> kept(const ThinningSettings& settings, std::uint64_t key, std::uint64_t snapshots) {
    SnapshotThinning thinning(settings, key);
    for (std::uint64_t update = 0; update < snapshots; ++update) {
        thinning.offer([&] {
            Sample sample;
            sample.record.update = update;
            return sample;
        });
    }
    EXPECT_EQ(thinning.offered(), snapshots);
    std::vector<std::uint64_t> updates;
    for (const Sample& sample : thinning.take()) {
        updates.push_back(sample.record.update);
    }
    return updates;
}

TEST(SnapshotThinning, KeepsOneOfEveryBlockInOrder) {
    const auto updates = kept({.every = 5, .most_per_run = 1000}, 1, 100);
    ASSERT_EQ(updates.size(), 20U);
    for (std::size_t block = 0; block < updates.size(); ++block) {
        EXPECT_EQ(updates[block] / 5, block);
    }
}

TEST(SnapshotThinning, KeepsAllWhereNothingIsToBeThinned) {
    EXPECT_EQ(kept({.every = 1, .most_per_run = 10}, 1, 10).size(), 10U);
}

TEST(SnapshotThinning, KeepsAsManyAsAllowedWhateverTheLength) {
    for (const std::uint64_t length : {30U, 300U, 3000U}) {
        const auto updates = kept({.every = 3, .most_per_run = 7}, 4, length);
        EXPECT_EQ(updates.size(), 7U);
        EXPECT_TRUE(std::is_sorted(updates.begin(), updates.end()));
    }
}

TEST(SnapshotThinning, EveryPlaceIsAsLikelyAsAnyOther) {
    std::vector<double> counts(40, 0.0);
    constexpr std::uint64_t keys = 4000;
    for (std::uint64_t key = 0; key < keys; ++key) {
        for (const std::uint64_t update : kept({.every = 4, .most_per_run = 5}, key, counts.size())) {
            counts[update] += 1.0;
        }
    }
    const double expected = 5.0 * keys / static_cast<double>(counts.size());
    for (const double count : counts) {
        EXPECT_NEAR(count, expected, 5.0 * std::sqrt(expected));
    }
}

TEST(SnapshotThinning, DependsOnTheKeyAlone) {
    const ThinningSettings settings{.every = 4, .most_per_run = 5};
    EXPECT_EQ(kept(settings, 1, 100), kept(settings, 1, 100));
    EXPECT_NE(kept(settings, 1, 100), kept(settings, 2, 100));
}

}  // namespace
}  // namespace ddtool::dataset
