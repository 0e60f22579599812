#include "maps/map_server_file.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>

#include "ddtool/base/error.hpp"
#include "maps/pgm_file.hpp"
#include "system/atomic_file.hpp"

namespace ddtool::maps {
namespace {

namespace fs = std::filesystem;

/// 5.7 km square with cells of 5 cm.
constexpr std::size_t most_pixels = std::size_t{1} << 27U;

enum class Mode { trinary, scale, raw };

struct Description {
    fs::path image;
    double resolution_m = 0.0;
    Pose2 origin;  ///< map_from_picture: of the lower left corner
    bool negate = false;
    double occupied_above = 0.65;
    double free_below = 0.196;
    Mode mode = Mode::trinary;
};

class DescriptionReader {
public:
    explicit DescriptionReader(const fs::path& file) : file_(file.string()) {
        try {
            root_ = YAML::Load(read_file(file));
        } catch (const YAML::Exception& error) {
            throw Error(file_ + ": no YAML: " + error.what());
        }
        if (!root_.IsMap()) {
            throw Error(file_ + ": expected keys and values of a map of map_server (image, resolution, origin, ...)");
        }
    }

    Description read() {
        Description map;
        const fs::path image = value<std::string>("image", "the name of a picture");
        map.image = image.is_absolute() ? image : fs::path(file_).parent_path() / image;
        map.resolution_m = value<double>("resolution", "metres per pixel");
        if (!(map.resolution_m >= 0.005 && map.resolution_m <= 1.0)) {
            fail("resolution", std::to_string(map.resolution_m), "0.005 to 1 m per pixel");
        }
        const auto origin = value<std::vector<double>>("origin", "[x, y, yaw]");
        if (origin.size() < 2 || origin.size() > 3 ||
            !std::ranges::all_of(origin, [](double number) { return std::abs(number) < 1e6; })) {
            fail("origin", std::to_string(origin.size()) + " numbers", "[x, y, yaw], below a million");
        }
        map.origin = {origin[0], origin[1], origin.size() == 3 ? wrap_angle(origin[2]) : 0.0};
        map.negate = flag("negate");
        map.occupied_above = share("occupied_thresh", map.occupied_above);
        map.free_below = share("free_thresh", map.free_below);
        if (map.free_below > map.occupied_above) {
            fail("free_thresh", std::to_string(map.free_below), "at most occupied_thresh");
        }
        map.mode = mode();
        return map;
    }

private:
    template <typename Value>
    Value value(const char* key, const char* expected) {
        const YAML::Node node = root_[key];
        if (!node) {
            throw Error(file_ + ": no '" + key + "'; expected " + expected);
        }
        try {
            return node.as<Value>();
        } catch (const YAML::Exception&) {
            fail(key, "something else", expected);
        }
    }

    bool flag(const char* key) {
        if (!root_[key]) {
            return false;
        }
        const std::string text = value<std::string>(key, "0 or 1");
        if (text == "0" || text == "false" || text == "False") {
            return false;
        }
        if (text == "1" || text == "true" || text == "True") {
            return true;
        }
        fail(key, "'" + text + "'", "0 or 1");
    }

    double share(const char* key, double usual) {
        const double number = root_[key] ? value<double>(key, "a number in 0..1") : usual;
        if (!(number >= 0.0 && number <= 1.0)) {
            fail(key, std::to_string(number), "a number in 0..1");
        }
        return number;
    }

    Mode mode() {
        const std::string name = root_["mode"] ? value<std::string>("mode", "a word") : "trinary";
        if (name == "trinary") {
            return Mode::trinary;
        }
        if (name == "scale") {
            return Mode::scale;
        }
        if (name == "raw") {
            return Mode::raw;
        }
        fail("mode", "'" + name + "'", "trinary, scale or raw");
    }

    [[noreturn]] void fail(const std::string& key, const std::string& found, const std::string& expected) const {
        throw Error(file_ + ": '" + key + "' is " + found + "; expected " + expected);
    }

    std::string file_;
    YAML::Node root_;
};

GreyPicture picture_of(const fs::path& image) {
    std::string start(2, '\0');
    std::ifstream(image, std::ios::binary).read(start.data(), 2);
    if (start == "P5" || start == "P2") {
        return read_pgm(image, most_pixels);
    }
    return read_png(image, most_pixels);
}

/// The value of a pixel as nav_msgs/OccupancyGrid has it: 0 free to 100 occupied; empty for unknown. As map_server's
/// image_loader and nav2's map_io compute it.
std::optional<int> occupancy(const Description& map, std::uint8_t grey, std::uint8_t opacity) {
    constexpr int most = 100;
    if (map.mode == Mode::raw) {
        return grey <= most ? std::optional<int>(grey) : std::nullopt;
    }
    const double occupied = (map.negate ? grey : 255 - grey) / 255.0;
    if (map.mode == Mode::scale && opacity < 255) {
        return std::nullopt;
    }
    if (occupied > map.occupied_above) {
        return most;
    }
    if (occupied < map.free_below) {
        return 0;
    }
    if (map.mode == Mode::trinary) {
        return std::nullopt;
    }
    const double share = (occupied - map.free_below) / std::max(map.occupied_above - map.free_below, 1e-9);
    return static_cast<int>(std::lround(1.0 + 98.0 * share));
}

/// The evidence for a value of 0..100, as far from nothing as the value is from a half; empty where that is nothing.
std::optional<std::int8_t> evidence(int value, const OccupancySettings& cells) {
    const double share = (value - 50) / 50.0;
    const double limit = share > 0.0 ? cells.max_log_odds : cells.min_log_odds;
    const auto log_odds = static_cast<std::int8_t>(std::lround(std::abs(share) * limit));
    return log_odds == 0 ? std::nullopt : std::optional(log_odds);
}

/// Puts the pixels into the grid, row by row from the lowest.
class Painter {
public:
    Painter(const Description& map, const GreyPicture& picture, OccupancyGrid& grid)
        : map_(map), picture_(picture), grid_(grid), cell_m_(grid.cell_size_m()) {}

    void paint() {
        const CellBox box = reach();
        grid_.reserve(box);
        if (map_.origin.theta_rad == 0.0) {
            each_pixel([&](int x, int y, std::int8_t log_odds) { enter(x, y, log_odds); });
            return;
        }
        // Free cells are looked up backwards, so that turning leaves no holes; occupied ones go where they are.
        const Pose2 picture_from_map = inverse(map_.origin);
        for (int y = box.y_min; y < box.y_max; ++y) {
            for (int x = box.x_min; x < box.x_max; ++x) {
                const Point2 at = picture_from_map * Point2{(x + 0.5) * cell_m_, (y + 0.5) * cell_m_};
                const auto log_odds = at_pixel(static_cast<int>(std::floor(at.x_m / cell_m_)),
                                               static_cast<int>(std::floor(at.y_m / cell_m_)));
                if (log_odds && *log_odds < 0) {
                    grid_.set({x, y}, *log_odds, {});
                }
            }
        }
        each_pixel([&](int x, int y, std::int8_t log_odds) {
            if (log_odds > 0) {
                enter(x, y, log_odds);
            }
        });
    }

private:
    [[nodiscard]] int width() const { return static_cast<int>(picture_.width_px); }
    [[nodiscard]] int height() const { return static_cast<int>(picture_.height_px); }

    [[nodiscard]] std::optional<std::int8_t> at_pixel(int x, int y) const {
        if (x < 0 || y < 0 || x >= width() || y >= height()) {
            return std::nullopt;
        }
        const std::size_t at =
            static_cast<std::size_t>(height() - 1 - y) * picture_.width_px + static_cast<std::size_t>(x);
        const std::uint8_t opacity = picture_.opacity.empty() ? std::uint8_t{255} : picture_.opacity[at];
        const std::optional<int> value = occupancy(map_, picture_.grey[at], opacity);
        return value ? evidence(*value, grid_.settings()) : std::nullopt;
    }

    template <typename Enter>
    void each_pixel(Enter&& enter_pixel) const {
        for (int y = 0; y < height(); ++y) {
            for (int x = 0; x < width(); ++x) {
                if (const auto log_odds = at_pixel(x, y)) {
                    enter_pixel(x, y, *log_odds);
                }
            }
        }
    }

    [[nodiscard]] Point2 centre_cells(int x, int y) const {
        const Point2 at = map_.origin * Point2{(x + 0.5) * cell_m_, (y + 0.5) * cell_m_};
        // The nudge keeps pixels that lie on the grid's own cells, but for rounding, in these.
        constexpr double nudge = 1e-6;
        return {at.x_m / cell_m_ + nudge, at.y_m / cell_m_ + nudge};
    }

    /// The mean of the hits of a pixel is its centre, wherever that lies in the cell.
    void enter(int x, int y, std::int8_t log_odds) {
        const Point2 at = centre_cells(x, y);
        const Cell cell{static_cast<int>(std::floor(at.x_m)), static_cast<int>(std::floor(at.y_m))};
        const auto offset = [](double cells) {
            constexpr int half = NearestPoint::units_per_cell / 2;
            return static_cast<std::int8_t>(std::clamp(
                static_cast<int>(std::floor((cells - std::floor(cells)) * NearestPoint::units_per_cell)) - half, -half,
                half - 1));
        };
        grid_.set(cell, log_odds, {offset(at.x_m), offset(at.y_m)});
    }

    [[nodiscard]] CellBox reach() const {
        const Point2 first = centre_cells(0, 0);
        CellBox box{static_cast<int>(std::floor(first.x_m)), static_cast<int>(std::floor(first.y_m)),
                    static_cast<int>(std::floor(first.x_m)), static_cast<int>(std::floor(first.y_m))};
        for (const auto& [x, y] : {std::pair{0, 0}, {width() - 1, 0}, {0, height() - 1}, {width() - 1, height() - 1}}) {
            const Point2 corner = centre_cells(x, y);
            box.x_min = std::min(box.x_min, static_cast<int>(std::floor(corner.x_m)) - 1);
            box.y_min = std::min(box.y_min, static_cast<int>(std::floor(corner.y_m)) - 1);
            box.x_max = std::max(box.x_max, static_cast<int>(std::floor(corner.x_m)) + 2);
            box.y_max = std::max(box.y_max, static_cast<int>(std::floor(corner.y_m)) + 2);
        }
        return box;
    }

    const Description& map_;
    const GreyPicture& picture_;
    OccupancyGrid& grid_;
    double cell_m_;
};

}  // namespace

SavedMap read_map_server(const std::filesystem::path& yaml) {
    const Description description = DescriptionReader(yaml).read();
    const GreyPicture picture = picture_of(description.image);
    SavedMap map({.cell_size_m = description.resolution_m});
    Painter(description, picture, map.grid).paint();
    return map;
}

}  // namespace ddtool::maps
