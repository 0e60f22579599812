#include "system/failure_text.hpp"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

namespace ddtool {
namespace {

TEST(FailureText, IsTheFirstLine) {
    EXPECT_EQ(failure_text(std::runtime_error("a: cannot read")), "a: cannot read");
    EXPECT_EQ(failure_text(std::runtime_error("no kernel\nException raised from\n#0 main")), "no kernel");
}

TEST(FailureText, NamesAShortageOfMemoryTheSameWhoeverSawIt) {
    const std::string text = failure_text(std::bad_alloc());
    EXPECT_NE(text.find("not enough memory"), std::string::npos);
    EXPECT_EQ(failure_text(std::runtime_error(
                  "OpenCV(4.6.0) ./alloc.cpp:73: error: (-4:Insufficient memory) Failed to allocate 9 bytes")),
              text);
    EXPECT_EQ(failure_text(std::runtime_error("pthread_create has failed: Resource temporarily unavailable")), text);
    EXPECT_EQ(
        failure_text(std::runtime_error(
            "[enforce fail at alloc_cpu.cpp:83] err == 0. DefaultCPUAllocator: can't allocate memory: you tried")),
        text);
}

}  // namespace
}  // namespace ddtool
