#include "report/thinning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ddtool/base/random.hpp"

namespace ddtool::report {
namespace {

using Lines = std::vector<std::vector<double>>;

Lines random_lines(std::size_t count, std::size_t rows) {
    RandomStream random({count, rows});
    Lines lines(count, std::vector<double>(rows));
    for (auto& line : lines) {
        std::generate(line.begin(), line.end(), [&] { return random.uniform(); });
    }
    return lines;
}

TEST(TellingRows, AreAllWhereThereIsRoom) {
    EXPECT_THAT(telling_rows(random_lines(2, 5), 5), testing::ElementsAre(0, 1, 2, 3, 4));
    EXPECT_THAT(telling_rows(random_lines(2, 0), 5), testing::IsEmpty());
    EXPECT_THAT(telling_rows({}, 5), testing::IsEmpty());
}

TEST(TellingRows, RiseFromTheFirstToTheLastAndAreNotTooMany) {
    for (const std::size_t rows : {21U, 100U, 1001U, 5000U}) {
        for (const std::size_t most : {20U, 97U, 1000U}) {
            const std::vector<std::size_t> kept = telling_rows(random_lines(3, rows), most);
            EXPECT_LE(kept.size(), most);
            EXPECT_EQ(kept.front(), 0);
            EXPECT_EQ(kept.back(), rows - 1);
            EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end(), std::less_equal<>()) &&
                        kept.size() > std::min(rows, most) / 4);
        }
    }
}

TEST(TellingRows, KeepEveryLinesExtremes) {
    const Lines lines = random_lines(4, 3000);
    const std::vector<std::size_t> kept = telling_rows(lines, 200);
    for (const auto& line : lines) {
        const auto extremes = std::minmax_element(line.begin(), line.end());
        EXPECT_THAT(kept, testing::Contains(extremes.first - line.begin()));
        EXPECT_THAT(kept, testing::Contains(extremes.second - line.begin()));
    }
}

TEST(TellingRows, PassOverMissingNumbers) {
    Lines lines{std::vector<double>(100, NAN)};
    lines[0][37] = 2.0;
    lines[0][38] = 1.0;
    EXPECT_THAT(telling_rows(lines, 10), testing::IsSupersetOf({37U, 38U}));
}

}  // namespace
}  // namespace ddtool::report
