#include "system/process_usage.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ddtool {
namespace {

TEST(ProcessUsage, GrowsWithWhatIsUsed) {
    const ProcessUsage before = process_usage();
    constexpr std::size_t size = std::size_t{256} << 20;
    const std::vector<char> memory(size, 'x');
    const ProcessUsage after = process_usage();
    EXPECT_GE(after.peak_memory_bytes, static_cast<std::int64_t>(size));
    EXPECT_GT(after.peak_memory_bytes, before.peak_memory_bytes);
    EXPECT_GE(after.cpu_s, before.cpu_s);
    EXPECT_EQ(memory.back(), 'x');
}

}  // namespace
}  // namespace ddtool
