#pragma once

#include <cstddef>
#include <cstdint>

namespace ddtool::report {

struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;

    bool operator==(const Colour&) const = default;
};

inline constexpr Colour white{255, 255, 255};
inline constexpr Colour black{0, 0, 0};
inline constexpr Colour grey{150, 150, 150};
inline constexpr Colour light_grey{225, 225, 225};

/// Seven colours that colour-blind people can tell apart (Okabe and Ito 2008, without yellow). From index 7 on they
/// repeat.
Colour series_colour(std::size_t index);

/// From dark blue (0) through red to orange (1), readable on white: most of matplotlib's "plasma".
Colour heat_colour(double fraction);

}  // namespace ddtool::report
