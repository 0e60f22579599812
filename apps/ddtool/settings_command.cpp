#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>

#include "commands.hpp"
#include "setting_lists.hpp"

namespace ddtool {
namespace {

bool is_numeric(Allowed::Kind kind) {
    return kind == Allowed::Kind::whole || kind == Allowed::Kind::number || kind == Allowed::Kind::numbers;
}

Json setting_json(const std::string& path, const Setting& setting, const Json& standard) {
    const Allowed& allowed = setting.allowed;
    Json json{{"key", path}, {"default", standard}, {"expected", allowed_text(allowed, setting.unit)}};
    if (is_numeric(allowed.kind)) {
        json["least"] = allowed.least;
        json["most"] = allowed.most;
    }
    if (allowed.kind == Allowed::Kind::word) {
        json["words"] = allowed.words;
    }
    json["unit"] = setting.unit;
    json["meaning"] = setting.meaning;
    json["source"] = setting.source;
    return json;
}

Json list_json(const SettingList& list) {
    Json settings = Json::array();
    for_each_setting(list.settings, [&](const std::string& path, const Setting& setting) {
        settings.push_back(setting_json(path, setting, setting_at(list.defaults, path)));
    });
    return {{"command", list.command}, {"settings", settings}};
}

void print_list(const SettingList& list) {
    for_each_setting(list.settings, [&](const std::string& path, const Setting& setting) {
        std::cout << path << " = " << setting_at(list.defaults, path).dump() << "\n    " << setting.meaning << '\n';
        for (const std::string& line : {allowed_text(setting.allowed, setting.unit), setting.source}) {
            std::cout << (line.empty() ? "" : "    " + line + "\n");
        }
    });
}

SettingList list_of(const std::string& command) {
    std::vector<SettingList> lists = setting_lists();
    const auto found =
        std::find_if(lists.begin(), lists.end(), [&](const SettingList& list) { return list.command == command; });
    if (found == lists.end()) {
        std::vector<std::string> known;
        std::transform(lists.begin(), lists.end(), std::back_inserter(known),
                       [](const auto& each) { return each.command; });
        throw UsageError("settings '" + command + "': expected " + joined(known));
    }
    return std::move(*found);
}

struct SettingsRequest {
    std::string command;
    bool as_json = false;
};

ExitCode print_settings(const SettingsRequest& request) {
    const SettingList list = list_of(request.command);
    if (request.as_json) {
        std::cout << list_json(list).dump(2) << '\n';
    } else {
        print_list(list);
    }
    return ExitCode::done;
}

}  // namespace

Command settings_command() {
    const auto request = std::make_shared<SettingsRequest>();
    return {
        .name = "settings",
        .summary = "What each setting is, with its default and its range",
        .example = "ddtool settings slam",
        .options =
            {
                {"COMMAND", &request->command, "Whose settings to print; ablation is the plan of eval --ablation",
                 choices({"slam", "simulate", "build-dataset", "train", "compare", "ablation"}), Presence::required},
                {"--json", &request->as_json, "Print JSON instead of text"},
            },
        .run = [request](const Json& /*settings*/) { return print_settings(*request); }};
}

}  // namespace ddtool
