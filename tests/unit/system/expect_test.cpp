#include "system/expect.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "thrown_text.hpp"

namespace ddtool {
namespace {

using test::thrown_text;

TEST(Expect, TakesARangeWithBothItsEnds) {
    for (const double value : {-1.0, 0.0, 2.5}) {
        expect_between("share", value, -1.0, 2.5);
    }
}

TEST(Expect, NamesKeyRangeAndValue) {
    EXPECT_EQ(thrown_text<UsageError>([] { expect_between("share", 3.5, -1.0, 2.5); }),
              "share: expected -1.0 to 2.5, not 3.5");
    for (const double outside : {-1.1, 2.6, std::nan(""), HUGE_VAL}) {
        EXPECT_NE(thrown_text<UsageError>([&] { expect_between("share", outside, -1.0, 2.5); }), "") << outside;
    }
}

TEST(Expect, FindsEveryKnownWordAtItsPlace) {
    const std::array<const char*, 3> words{"one", "two", "three"};
    for (std::size_t place = 0; place < words.size(); ++place) {
        EXPECT_EQ(expect_one_of("number", words[place], words), place);
    }
    EXPECT_EQ(thrown_text<UsageError>([&] { expect_one_of("number", "four", words); }),
              "number: expected one of one, two, three, not 'four'");
}

}  // namespace
}  // namespace ddtool
