#include "sim/world_catalogue.hpp"

#include <charconv>
#include <optional>

#include "ddtool/base/error.hpp"
#include "ddtool/system/settings.hpp"
#include "sim/builtin_worlds.hpp"
#include "sim/random_worlds.hpp"
#include "sim/texture.hpp"
#include "sim/world_json.hpp"
#include "system/atomic_file.hpp"

namespace ddtool::sim {
namespace {

constexpr std::string_view textured_suffix = "-textured";
constexpr std::string_view random_prefix = "random:";

Json parse_world(const std::string& text, const std::string& source) {
    try {
        return parse_json(text, source, /*comments=*/true);
    } catch (const Json::parse_error& error) {
        throw UsageError(source + ": not JSON at byte " + std::to_string(error.byte));
    }
}

struct RandomKind {
    const char* name;
    const char* description;
    World (*draw)(std::uint64_t seed);
};

constexpr RandomKind random_kinds[] = {
    {"random:office:SEED", "a corridor with rooms, doors and furniture, drawn by seed", random_office},
    {"random:corridors:SEED", "corridors at right angles or a ring of them, drawn by seed", random_corridors},
    {"random:open:SEED", "open ground with landmarks and walls, drawn by seed", random_open},
    {"random:recessed-corridor:SEED", "a straight corridor with recesses, drawn by seed", random_recessed_corridor},
    {"random:recessed-ring:SEED", "a ring of corridors with recesses, drawn by seed", random_recessed_ring},
    {"random:recessed-eight:SEED", "two such rings that meet, drawn by seed", random_recessed_eight},
};

World draw_random(const std::string& name) {
    const std::size_t colon = name.rfind(':');
    const std::string kind = name.substr(0, colon) + ":SEED";
    std::uint64_t seed = 0;
    const char* end = name.data() + name.size();
    const auto [last, error] = std::from_chars(name.data() + colon + 1, end, seed);
    std::string kinds;
    for (const RandomKind& known : random_kinds) {
        kinds += (kinds.empty() ? "" : ", ") + std::string(known.name);
        if (kind == known.name && error == std::errc() && last == end) {
            return known.draw(seed);
        }
    }
    throw UsageError("unknown world '" + name + "'; expected one of " + kinds + "; SEED is a number");
}

std::vector<World> parse_builtin_worlds() {
    std::vector<World> worlds;
    for (const std::string_view text : builtin_worlds()) {
        worlds.push_back(world_from_json(parse_world(std::string(text), "built-in world"), "built-in world"));
    }
    return worlds;
}

World find_builtin(const std::string& name) {
    std::string known;
    for (const World& world : parse_builtin_worlds()) {
        if (world.name == name) {
            return world;
        }
        known += (known.empty() ? "" : ", ") + world.name;
    }
    throw UsageError("unknown world '" + name + "'; expected one of " + known + ", random:KIND:SEED or a file.json");
}

World load_plain(const std::string& name) {
    if (name.starts_with(random_prefix)) {
        return draw_random(name);
    }
    if (name.ends_with(".json")) {
        return world_from_json(parse_world(read_file(name), name), name);
    }
    return find_builtin(name);
}

}  // namespace

World load_world(const std::string& name) {
    if (name.ends_with(textured_suffix)) {
        return textured(load_plain(name.substr(0, name.size() - textured_suffix.size())));
    }
    return load_plain(name);
}

std::vector<WorldEntry> list_worlds() {
    std::vector<WorldEntry> entries;
    for (const World& world : parse_builtin_worlds()) {
        entries.push_back({world.name, world.description});
    }
    for (const RandomKind& kind : random_kinds) {
        entries.push_back({kind.name, kind.description});
    }
    return entries;
}

}  // namespace ddtool::sim
