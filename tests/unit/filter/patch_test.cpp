#include "ddtool/filter/patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "ddtool/base/random.hpp"
#include "ddtool/base/thread_pool.hpp"

namespace ddtool {
namespace {

TEST(PatchPointer, CopiesShareUntilOneWrites) {
    PatchPointer one;
    one.writable().log_odds[5] = 3;
    PatchPointer two = one;
    EXPECT_EQ(&*one, &*two);
    two.writable().log_odds[5] = 7;
    EXPECT_NE(&*one, &*two);
    EXPECT_EQ(one->log_odds[5], 3);
    EXPECT_EQ(two->log_odds[5], 7);
}

TEST(PatchPointer, SoleOwnerWritesInPlace) {
    PatchPointer one;
    const Patch* const first = &one.writable();
    { const PatchPointer two = one; }
    EXPECT_EQ(&one.writable(), first);
}

TEST(PatchPointer, WritingNeverReachesTheEmptyPatch) {
    PatchPointer written;
    ASSERT_TRUE(written.empty());
    written.writable().log_odds.fill(1);
    EXPECT_FALSE(written.empty());
    const PatchPointer fresh;
    EXPECT_TRUE(fresh.empty());
    EXPECT_TRUE(std::all_of(fresh->log_odds.begin(), fresh->log_odds.end(),
                            [](std::int8_t value) { return value == Patch::unknown; }));
}

/// Copies, moves, writes and drops pointers at random, and compares them with plain values, which never share anything.
TEST(PatchPointer, BehavesAsAValueAndCountsItsOwners) {
    constexpr std::size_t slots = 6;
    RandomStream random{1};
    std::vector<PatchPointer> pointers(slots);
    std::vector<std::int8_t> values(slots, Patch::unknown);
    for (int step = 0; step < 5'000; ++step) {
        const std::size_t from = random.index(slots);
        const std::size_t to = random.index(slots);
        switch (random.index(4)) {
            case 0:
                pointers[to] = pointers[from];
                values[to] = values[from];
                break;
            case 1:
                std::swap(pointers[to], pointers[from]);
                std::swap(values[to], values[from]);
                break;
            case 2:
                values[to] = static_cast<std::int8_t>(random.index(100));
                pointers[to].writable().log_odds.back() = values[to];
                break;
            default:
                pointers[to] = PatchPointer();
                values[to] = Patch::unknown;
        }
        for (std::size_t slot = 0; slot < slots; ++slot) {
            ASSERT_EQ(pointers[slot]->log_odds.back(), values[slot]) << "step " << step;
            const auto sharing = std::count_if(pointers.begin(), pointers.end(),
                                               [&](const PatchPointer& other) { return &*other == &*pointers[slot]; });
            ASSERT_EQ(pointers[slot].empty() || pointers[slot]->owners == static_cast<std::uint32_t>(sharing), true);
        }
    }
}

/// Owners on several threads write to the same patches, and the last one becomes their only owner. The test is meant
/// for the thread sanitizer and for the search for leaks.
TEST(PatchPointer, OwnersOnManyThreadsKeepTheirOwnContent) {
    constexpr std::size_t owners = 4;
    ThreadPool threads(owners);
    for (int round = 0; round < 40; ++round) {
        std::vector<PatchPointer> original(100);
        for (PatchPointer& patch : original) {
            patch.writable().log_odds[0] = 50;
        }
        std::vector<std::vector<PatchPointer>> shared(owners, original);
        original.clear();
        threads.for_each(owners, [&](std::size_t owner, std::size_t) {
            for (PatchPointer& patch : shared[owner]) {
                patch.writable().log_odds[1] = static_cast<std::int8_t>(owner);
            }
        });
        for (std::size_t owner = 0; owner < owners; ++owner) {
            for (const PatchPointer& patch : shared[owner]) {
                ASSERT_EQ(patch->log_odds[0], 50);
                ASSERT_EQ(patch->log_odds[1], static_cast<std::int8_t>(owner));
            }
        }
    }
}

}  // namespace
}  // namespace ddtool
