#include "jobs/runner.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <csignal>
#include <map>
#include <mutex>

#include "system/atomic_file.hpp"

namespace ddtool::jobs {
namespace {

using testing::ElementsAre;

/// The jobs compute squares of numbers, and the results are kept in a map.
class RunnerTest : public ::testing::Test {
protected:
    [[nodiscard]] Job<int> square_of(int number) {
        return {.id = std::to_string(number),
                .title = "square of " + std::to_string(number),
                .find = [this, number]() -> std::optional<int> {
                    const auto found = stored_.find(number);
                    return found == stored_.end() ? std::nullopt : std::optional(found->second);
                },
                .make = [this, number](const OnProgress& on_progress) { return make(number, on_progress); },
                .note = [](const int& square) { return "it is " + std::to_string(square); }};
    }
    [[nodiscard]] std::vector<Job<int>> squares_of(const std::vector<int>& numbers) {
        std::vector<Job<int>> jobs;
        for (const int number : numbers) {
            jobs.push_back(square_of(number));
        }
        return jobs;
    }
    [[nodiscard]] Outcome<int> run_all(const std::vector<int>& numbers, std::size_t threads = 1) {
        ThreadPool pool(threads);
        return run(squares_of(numbers), pool, {"squaring", "numbers"});
    }

    int make(int number, const OnProgress& on_progress) {
        on_progress(0.5);
        if (number == wrong_) {
            throw std::runtime_error("no square\nof it");
        }
        if (number == unwritable_) {
            throw OutputError("the disk is full");
        }
        if (number == last_) {
            std::raise(SIGINT);
            on_progress(0.9);
        }
        const std::scoped_lock lock(mutex_);
        made_.push_back(number);
        return stored_[number] = number * number;
    }

    std::map<int, int> stored_;
    std::vector<int> made_;
    int wrong_ = -1;
    int unwritable_ = -1;
    int last_ = -1;
    std::mutex mutex_;
};

TEST_F(RunnerTest, MakesWhatIsMissingOnce) {
    stored_[3] = 9;
    const Outcome<int> outcome = run_all({2, 3, 2, 5});
    EXPECT_EQ(outcome.made, 2U);
    EXPECT_THAT(made_, ElementsAre(2, 5));
    std::vector<int> values;
    for (const Result<int>& result : outcome.results) {
        EXPECT_EQ(result.failure, "");
        values.push_back(result.value.value());
    }
    EXPECT_THAT(values, ElementsAre(4, 9, 4, 25));
    EXPECT_EQ(run_all({2, 3, 5}).made, 0U);
}

TEST_F(RunnerTest, OneThatFailsStopsNoOtherAndIsTriedAgain) {
    wrong_ = 2;
    const Outcome<int> outcome = run_all({1, 2, 3, 2}, 2);
    EXPECT_EQ(outcome.made, 3U);
    for (const std::size_t place : {1U, 3U}) {
        EXPECT_EQ(outcome.results[place].failure, "no square");
        EXPECT_FALSE(outcome.results[place].value);
    }
    EXPECT_EQ(outcome.results[2].value, 9);
    wrong_ = -1;
    EXPECT_EQ(run_all({1, 2, 3, 2}).made, 1U);
}

TEST_F(RunnerTest, WhatCannotBeWrittenEndsItAll) {
    unwritable_ = 2;
    EXPECT_THROW((void)run_all({1, 2, 3}), OutputError);
    EXPECT_THAT(made_, ElementsAre(1));
}

TEST_F(RunnerTest, AStopKeepsWhatIsFinishedAndStartsNothingNew) {
    last_ = 3;
    EXPECT_THROW((void)run_all({1, 2, 3, 4}), Stopped);
    EXPECT_THAT(made_, ElementsAre(1, 2));
    last_ = -1;
    EXPECT_EQ(run_all({1, 2, 3, 4}).made, 2U);
}

TEST_F(RunnerTest, HasNothingToDoWithoutJobs) {
    const Outcome<int> outcome = run_all({});
    EXPECT_EQ(outcome.made, 0U);
    EXPECT_TRUE(outcome.results.empty());
}

}  // namespace
}  // namespace ddtool::jobs
