#include "grid/patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/random.hpp"
#include "base/thread_pool.hpp"

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

/// Pointers that are copied, moved, written and dropped at random, beside plain values that never share.
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

/// Owners on several threads copy, write and release one patch at a time; for the thread sanitizer, and for leaks.
TEST(PatchPointer, OwnersOnManyThreadsKeepTheirOwnContent) {
    constexpr std::size_t owners = 8;
    ThreadPool threads(4);
    for (int round = 0; round < 200; ++round) {
        PatchPointer original;
        original.writable().log_odds[0] = 50;
        std::vector<PatchPointer> shared(owners, original);
        original = PatchPointer();
        std::vector<int> seen(owners);
        threads.for_each(owners, [&](std::size_t owner, std::size_t) {
            const auto own = static_cast<std::int8_t>(owner);
            shared[owner].writable().log_odds[1] = own;
            PatchPointer copy = shared[owner];
            copy.writable().log_odds[0] = own;
            seen[owner] = shared[owner]->log_odds[0] * 100 + shared[owner]->log_odds[1];
            if (owner % 2 == 0) {
                shared[owner] = PatchPointer();
            }
        });
        for (std::size_t owner = 0; owner < owners; ++owner) {
            ASSERT_EQ(seen[owner], 5'000 + static_cast<int>(owner));
        }
    }
}

}  // namespace
}  // namespace ddtool
