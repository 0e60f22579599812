#include <gtest/gtest.h>

#include <filesystem>

#include "readers.hpp"
#include "system/atomic_file.hpp"

namespace ddtool::fuzz {
namespace {

/// Reads all inputs findings/READER/NAME: those in which fuzzing once found a fault, and some that were written to
/// cause harm. The test fails if a reader crashes or throws anything but ddtool::Error.
TEST(FuzzFindings, AreReadWithoutHarm) {
    std::size_t inputs = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(DDTOOL_FINDINGS)) {
        if (entry.is_regular_file()) {
            const std::string reader = entry.path().parent_path().filename().string();
            const std::string content = read_file(entry.path());
            SCOPED_TRACE(entry.path().string());
            ASSERT_NO_THROW(readers().at(reader)({content.data(), content.size()}));
            ++inputs;
        }
    }
    EXPECT_GE(inputs, 5U);
}

}  // namespace
}  // namespace ddtool::fuzz
