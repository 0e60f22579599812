#include "maps/going_on.hpp"

#include <exception>

namespace ddtool::maps {
namespace {

const SettingTable<GoingOnSettings>& going_on_rows() {
    using GoingOn = GoingOnSettings;
    static const SettingTable<GoingOn> rows{
        {"half_life_scans", &GoingOn::half_life_scans, Allowed::whole(0, 1000), "",
         "With --map, the evidence for a wall halves with so many scans that see through it, so that what was moved "
         "since the map was made gives way; 0: a wall is free only when as much speaks against it as for it.",
         "docs/maps.md"},
        {"covering_scans", &GoingOn::covering_scans, Allowed::whole(0, 1000), "",
         "With --map, a scan of an earlier drive is dropped from the map file if so many later scans observed the "
         "ground that it observed; 0: all are kept.",
         "docs/maps.md"},
    };
    return rows;
}

}  // namespace

std::vector<Setting> going_on_setting_list() { return going_on_rows().settings(); }

Json going_on_json(const GoingOnSettings& settings) { return going_on_rows().json(settings); }

GoingOnSettings going_on_from_json(const Json& json) { return going_on_rows().checked(json, going_on_name); }

int half_life_of(const Json& settings_of_run) {
    GoingOnSettings settings;
    if (settings_of_run.is_object() && settings_of_run.contains(going_on_name)) {
        Json json = going_on_json(settings);
        json.update(settings_of_run.at(going_on_name));
        try {
            settings = going_on_from_json(json);
        } catch (const std::exception&) {  // the settings of a file are not to be trusted
            return GoingOnSettings{}.half_life_scans;
        }
    }
    return settings.half_life_scans;
}

}  // namespace ddtool::maps
