#include "ddtool/base/thread_pool.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace ddtool {
namespace {

class ThreadPoolOf : public testing::TestWithParam<std::size_t> {
protected:
    ThreadPool pool_{GetParam()};
};

TEST_P(ThreadPoolOf, HasThatManyWorkers) { EXPECT_EQ(pool_.size(), GetParam()); }

TEST_P(ThreadPoolOf, TakesEveryIndexOnce) {
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
        std::vector<std::atomic<int>> calls(count);
        pool_.for_each(count, [&](std::size_t index, std::size_t worker) {
            EXPECT_LT(worker, pool_.size());
            ++calls[index];
        });
        for (const auto& each : calls) {
            EXPECT_EQ(each, 1);
        }
    }
}

TEST_P(ThreadPoolOf, NoTwoIterationsShareAWorkerAtOnce) {
    std::vector<std::atomic<int>> inside(pool_.size());
    pool_.for_each(1000, [&](std::size_t, std::size_t worker) {
        EXPECT_EQ(++inside[worker], 1);
        --inside[worker];
    });
}

TEST_P(ThreadPoolOf, RethrowsAndWorksOn) {
    const auto fail_at_seven = [](std::size_t index, std::size_t) {
        if (index == 7) {
            throw std::runtime_error("seven");
        }
    };
    for (int round = 0; round < 20; ++round) {
        EXPECT_THROW(pool_.for_each(100, fail_at_seven), std::runtime_error);
        std::atomic<int> calls = 0;
        pool_.for_each(10, [&](std::size_t, std::size_t) { ++calls; });
        EXPECT_EQ(calls, 10);
    }
}

INSTANTIATE_TEST_SUITE_P(Threads, ThreadPoolOf, testing::Values(1, 2, 5));

}  // namespace
}  // namespace ddtool
