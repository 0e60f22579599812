#include "report/map_files.hpp"

#include <array>
#include <cstdio>
#include <ostream>
#include <string>

#include "system/atomic_file.hpp"

namespace ddtool {
namespace {

void write_pgm(std::ostream& out, const MapRaster& map) {
    out << "P5\n" << map.width << " " << map.height << "\n255\n";
    const std::vector<std::uint8_t> pixels = map_pixels(map);
    out.write(reinterpret_cast<const char*>(pixels.data()), static_cast<std::streamsize>(pixels.size()));
}

/// free_thresh must lie below (255 - 205) / 255 = 0.19608, so that readers take the grey 205 for unknown.
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
