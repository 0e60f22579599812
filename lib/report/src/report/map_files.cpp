#include "report/map_files.hpp"

#include <array>
#include <cstdio>
#include <ostream>
#include <string>

#include "system/atomic_file.hpp"

namespace ddtool {
namespace {

char grey(std::int8_t cell) {
    if (cell == MapRaster::unknown) {
        return static_cast<char>(205);
    }
    return cell == MapRaster::occupied ? static_cast<char>(0) : static_cast<char>(254);
}

void write_pgm(std::ostream& out, const MapRaster& map) {
    out << "P5\n" << map.width << " " << map.height << "\n255\n";
    std::string row(map.width, '\0');
    for (std::size_t y = map.height; y-- > 0;) {
        for (std::size_t x = 0; x < map.width; ++x) {
            row[x] = grey(map.cells[y * map.width + x]);
        }
        out << row;
    }
}

/// The free threshold lies below (255 - 205) / 255, so that grey 205 stays unknown.
std::string yaml(const std::string& image, const MapRaster& map) {
    std::array<char, 512> text{};
    std::snprintf(text.data(), text.size(),
                  "image: %s\nmode: trinary\nresolution: %.9g\norigin: [%.9g, %.9g, 0]\nnegate: 0\n"
                  "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
                  image.c_str(), map.cell_size_m, map.origin_m.x_m, map.origin_m.y_m);
    return text.data();
}

}  // namespace

void write_map_files(const std::filesystem::path& folder, const std::string& name, const MapRaster& map) {
    const std::string image = name + ".pgm";
    write_file(folder / image, [&](std::ostream& out) { write_pgm(out, map); });
    write_file(folder / (name + ".yaml"), yaml(image, map));
}

}  // namespace ddtool
