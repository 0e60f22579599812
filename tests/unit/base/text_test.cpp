#include "base/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace ddtool {
namespace {

TEST(ParseStamp, KeepsEveryNanosecond) {
    EXPECT_EQ(parse_stamp("1700000000.123456789"), 1'700'000'000'123'456'789);
    EXPECT_EQ(parse_stamp("-1700000000.123456789"), -1'700'000'000'123'456'789);
    EXPECT_EQ(parse_stamp("1.700000000123456789e+09"), 1'700'000'000'123'456'789);
    EXPECT_EQ(parse_stamp("-2.5e-01"), -250'000'000);
    EXPECT_EQ(parse_stamp("-0.000000001"), -1);
    EXPECT_EQ(parse_stamp("0.9999999999"), 1'000'000'000);
    EXPECT_EQ(parse_stamp("7"), 7'000'000'000);
}

TEST(ParseStamp, RefusesWhatIsNoStamp) {
    for (const std::string word : {"", "x", "-", "5-0.3", "5x", "1.2.3", "1e400", "nan", "inf", "9000000001", "9.1e9",
                                   "-9223372036854775808", "1e", "5.3inf", "5nan"}) {
        EXPECT_EQ(parse_stamp(word), std::nullopt) << word;
    }
}

TEST(ParseNumber, TakesTheWholeWordOrNothing) {
    EXPECT_EQ(parse_number("-1.5e3"), -1500.0);
    for (const std::string word : {"", "1.5x", "nan", "inf", "1e999", "1,5"}) {
        EXPECT_EQ(parse_number(word), std::nullopt) << word;
    }
}

TEST(FixedText, HasThatManyDecimals) {
    EXPECT_EQ(fixed_text(3.14159, 2), "3.14");
    EXPECT_EQ(fixed_text(-2.0, 0), "-2");
    EXPECT_EQ(fixed_text(1e20, 1), "100000000000000000000.0");
    EXPECT_EQ(fixed_text(std::nan(""), 2), "-");
}

TEST(NextWord, PartsAtBlanksTabsCommasAndReturns) {
    std::string_view line = "  a,b\tc \r";
    EXPECT_EQ(next_word(line), "a");
    EXPECT_EQ(next_word(line), "b");
    EXPECT_EQ(next_word(line), "c");
    EXPECT_EQ(next_word(line), "");
    EXPECT_EQ(next_word(line), "");
}

}  // namespace
}  // namespace ddtool
