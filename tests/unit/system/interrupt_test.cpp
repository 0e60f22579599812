#include "system/interrupt.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace ddtool {
namespace {

TEST(InterruptRequest, IsMadeByTheFirstSignal) {
    const InterruptRequest request;
    EXPECT_FALSE(request.made());
    std::raise(SIGINT);
    EXPECT_TRUE(request.made());
}

TEST(InterruptRequest, StartsAnew) {
    {
        const InterruptRequest request;
        std::raise(SIGTERM);
    }
    EXPECT_FALSE(InterruptRequest().made());
}

TEST(InterruptRequest, InsideAnotherAsksBoth) {
    const InterruptRequest outer;
    {
        const InterruptRequest inner;
        std::raise(SIGINT);
        EXPECT_TRUE(inner.made());
    }
    EXPECT_TRUE(outer.made());
    EXPECT_TRUE(InterruptRequest().made()) << "of the work that begins inside, too";
}

TEST(InterruptRequest, AnEndedOneInsideLeavesTheOtherAtWork) {
    const InterruptRequest outer;
    { const InterruptRequest inner; }
    std::raise(SIGTERM);
    EXPECT_TRUE(outer.made());
}

TEST(InterruptRequestDeathTest, TheSecondSignalEndsTheProgram) {
    EXPECT_EXIT(
        {
            const InterruptRequest request;
            std::raise(SIGINT);
            std::raise(SIGINT);
        },
        testing::KilledBySignal(SIGINT), "");
}

}  // namespace
}  // namespace ddtool
