#include "report/colour.hpp"

#include <gmock/gmock.h>

namespace ddtool::report {
namespace {

double brightness(Colour colour) { return 0.3 * colour.red + 0.6 * colour.green + 0.1 * colour.blue; }

TEST(SeriesColour, DiffersBetweenSevenSeriesThenRepeats) {
    for (std::size_t a = 0; a < 7; ++a) {
        for (std::size_t b = a + 1; b < 7; ++b) {
            EXPECT_NE(series_colour(a), series_colour(b));
        }
    }
    EXPECT_EQ(series_colour(7), series_colour(0));
}

TEST(HeatColour, GetsBrighterWithTheValueAndStaysReadableOnWhite) {
    for (int tenth = 0; tenth < 10; ++tenth) {
        EXPECT_LT(brightness(heat_colour(0.1 * tenth)), brightness(heat_colour(0.1 * (tenth + 1))));
    }
    EXPECT_LT(brightness(heat_colour(1.0)), 200.0);
}

TEST(HeatColour, HoldsAtTheEnds) {
    EXPECT_EQ(heat_colour(-5.0), heat_colour(0.0));
    EXPECT_EQ(heat_colour(5.0), heat_colour(1.0));
}

}  // namespace
}  // namespace ddtool::report
