#include "maps/pgm_file.hpp"

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

#include "ddtool/base/error.hpp"
#include "system/atomic_file.hpp"

namespace ddtool::maps {
namespace {

constexpr std::size_t most_grey = 65535;

class PgmReader {
public:
    PgmReader(const std::filesystem::path& file, std::size_t most_pixels)
        : file_(file.string()), bytes_(read_file(file)), rest_(bytes_), most_pixels_(most_pixels) {}

    GreyPicture read() {
        const std::string_view kind = word();
        if (kind != "P5" && kind != "P2") {
            throw Error(file_ + ": begins with '" + std::string(kind.substr(0, 8)) +
                        "'; expected a PGM picture, which begins with P5 or P2");
        }
        GreyPicture picture;
        picture.width_px = number("its width", 1, most_pixels_);
        picture.height_px = number("its height", 1, most_pixels_ / picture.width_px);
        const std::size_t white = number("its lightest grey", 1, most_grey);
        const std::size_t pixels = picture.width_px * picture.height_px;
        const std::size_t bytes = white > 255 ? 2 : 1;
        if (kind == "P5") {
            rest_.remove_prefix(std::min<std::size_t>(1, rest_.size()));  // the one blank behind the head
            if (rest_.size() < pixels * bytes) {
                throw Error(file_ + ": " + std::to_string(rest_.size()) + " bytes of pixels; expected " +
                            std::to_string(pixels * bytes));
            }
        }
        for (std::size_t i = 0; i < pixels; ++i) {
            const std::size_t grey = kind == "P2" ? number("a grey", 0, white) : value(i, bytes);
            picture.grey.push_back(static_cast<std::uint8_t>(std::min(grey, white) * 255 / white));
        }
        return picture;
    }

private:
    [[nodiscard]] std::size_t value(std::size_t pixel, std::size_t bytes) const {
        const auto byte = [&](std::size_t at) { return std::size_t{static_cast<unsigned char>(rest_[at])}; };
        return bytes == 1 ? byte(pixel) : 256 * byte(2 * pixel) + byte(2 * pixel + 1);
    }

    std::string_view word() {
        constexpr std::string_view blanks = " \t\r\n";
        while (true) {
            rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
            if (!rest_.starts_with('#')) {
                break;
            }
            rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
        }
        const std::string_view found = rest_.substr(0, rest_.find_first_of(blanks));
        rest_.remove_prefix(found.size());
        return found;
    }

    std::size_t number(const char* what, std::size_t least, std::size_t most) {
        const std::string_view text = word();
        std::size_t value = 0;
        const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (problem != std::errc() || end != text.data() + text.size() || value < least || value > most) {
            throw Error(file_ + ": " + what + " is '" + std::string(text.substr(0, 20)) + "'; expected " +
                        std::to_string(least) + " to " + std::to_string(most));
        }
        return value;
    }

    std::string file_;
    std::string bytes_;
    std::string_view rest_;
    std::size_t most_pixels_;
};

}  // namespace

GreyPicture read_pgm(const std::filesystem::path& file, std::size_t most_pixels) {
    return PgmReader(file, most_pixels).read();
}

}  // namespace ddtool::maps
