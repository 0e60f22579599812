#include "maps/any_map.hpp"

#include "ddtool/base/error.hpp"
#include "maps/map_server_file.hpp"

namespace ddtool::maps {

SavedMap read_any_map(const std::filesystem::path& file, MapParts parts) {
    namespace fs = std::filesystem;
    if (fs::is_directory(file)) {
        for (const char* name : {"map.ddmap", "map.yaml"}) {
            if (fs::exists(file / name)) {
                return read_any_map(file / name, parts);
            }
        }
        throw Error(file.string() + ": a folder without a map; expected map.ddmap or map.yaml in it");
    }
    if (!fs::exists(file)) {
        throw Error(file.string() +
                    ": there is no such file; expected map.ddmap as ddtool slam writes it, or map.yaml");
    }
    if (looks_like_map_file(file)) {
        return read_map(file, parts);
    }
    const std::string ending = file.extension().string();
    if (ending == ".yaml" || ending == ".yml") {
        return read_map_server(file);
    }
    throw Error(file.string() +
                ": no map; expected map.ddmap as ddtool slam writes it, or the map.yaml of a map of map_server");
}

}  // namespace ddtool::maps
