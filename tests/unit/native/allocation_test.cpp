#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include "dd_weights.hpp"
#include "native/dd_network.hpp"

namespace {
std::atomic<int> allocations{0};
}  // namespace

// Not inline: GCC would take one half of a pair for a mismatch with the other.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* const memory = std::malloc(size)) {
        return memory;
    }
    throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
    ++allocations;
    if (void* const memory = std::aligned_alloc(static_cast<std::size_t>(alignment), (size + 63) / 64 * 64)) {
        return memory;
    }
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace ddtool::native {
namespace {

TEST(DDNetwork, AllocatesNothingWhenItRuns) {
    constexpr std::size_t size_px = 64;
    const native::DDModelTable& table = native::ddmodel_lite_table();
    NamedWeights weights(test::drawn_dd_weights(table, size_px));
    DDNetwork network(weights, table, size_px);
    const std::vector<float> image(size_px * size_px, 1.0F);
    const int before = allocations;
    EXPECT_GT(before, 0);
    (void)network.run(image);
    EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace ddtool::native
