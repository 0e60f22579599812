#include "setting_lists.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include "dataset/build_settings.hpp"
#include "dataset/run_plan.hpp"
#include "ddtool/base/error.hpp"
#include "localization/localization_settings.hpp"
#include "log_options.hpp"
#include "maps/going_on.hpp"
#include "methods/settings_json.hpp"
#include "sim/simulation_json.hpp"
#include "study/ablation/plan.hpp"
#include "study/compare/experiment.hpp"
#include "train/train_settings.hpp"

namespace ddtool {
namespace {

/// Reads the settings in the same way as the command that has them.
using Reader = std::function<void(const Json& settings)>;

const std::map<std::string, Reader>& readers() {
    static const std::map<std::string, Reader> table{
        {"slam",
         [](const Json& settings) {
             (void)log_options(settings.at("log"));
             (void)filter_settings_from_json(settings.at("filter"));
             (void)asks_for_graph(settings);
             (void)maps::going_on_from_json(settings.at(maps::going_on_name));
         }},
        {"localize",
         [](const Json& settings) {
             (void)log_options(settings.at("log"));
             (void)localization::localization_from_json(settings);
         }},
        {"simulate", [](const Json& settings) { (void)sim::simulation_from_json(settings); }},
        {"build-dataset",
         [](Json settings) {
             settings["worlds"] = {"s1"};
             (void)dataset::assembly_from_json(settings);
             (void)dataset::plan_runs(settings);
         }},
        {"train", [](const Json& settings) { (void)train::train_settings_from_json(settings); }},
        {"compare",
         [](Json settings) {
             settings["worlds"] = {"s1"};
             settings["methods"] = {{{"name", "one"}}};
             (void)compare::cells_of(compare::experiment_from_json(settings));
         }},
        {"ablation",
         [](Json settings) {
             settings["rows"] = {{{"name", "one"}}};
             (void)ablation::plan_from_json(settings);
         }},
    };
    return table;
}

Json::json_pointer pointer_to(std::string path) {
    std::replace(path.begin(), path.end(), '.', '/');
    return Json::json_pointer("/" + path);
}

void collect_leaves(const Json& json, const std::string& path, std::set<std::string>& leaves) {
    for (const auto& [key, value] : json.items()) {
        const std::string own = path.empty() ? key : std::string(path).append(".").append(key);
        if (value.is_object()) {
            collect_leaves(value, own, leaves);
        } else {
            leaves.insert(own);
        }
    }
}

/// Values that the setting must refuse.
std::vector<Json> refused_by(const Setting& setting) {
    const Allowed& allowed = setting.allowed;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    switch (allowed.kind) {
        case Allowed::Kind::whole: {
            std::vector<Json> values{static_cast<std::int64_t>(allowed.least) - 1, allowed.least + 0.5, nan, infinite,
                                     "1"};
            if (allowed.most < 1e18) {
                values.emplace_back(static_cast<std::int64_t>(allowed.most) + 1);
            }
            return values;
        }
        case Allowed::Kind::number:
            return {std::nextafter(allowed.least, -infinite),
                    std::nextafter(allowed.most, infinite),
                    nan,
                    -infinite,
                    infinite,
                    "1"};
        case Allowed::Kind::word:
            return {"no such word", 1};
        case Allowed::Kind::flag:
            return {1, "true"};
        case Allowed::Kind::numbers: {
            std::vector<double> with_nan(allowed.count == 0 ? 3 : allowed.count, 1.0);
            with_nan.back() = nan;
            std::vector<double> too_large = with_nan;
            too_large.back() = allowed.most + 1.0;
            std::vector<Json> refused{with_nan, too_large, "1"};
            if (allowed.count > 0) {
                refused.emplace_back(std::vector<double>(allowed.count + 1, 1.0));
            }
            return refused;
        }
        case Allowed::Kind::text:
        case Allowed::Kind::other:
            break;
    }
    return {};
}

std::string said(const std::string& command, const Json& settings) {
    try {
        readers().at(command)(settings);
    } catch (const UsageError& error) {
        return error.what();
    } catch (const std::exception& error) {
        return std::string("no UsageError: ") + error.what();
    }
    return "";
}

class SettingLists : public testing::TestWithParam<SettingList> {};

TEST_P(SettingLists, HaveARowForEverySetting) {
    std::set<std::string> leaves;
    collect_leaves(GetParam().defaults, "", leaves);
    std::set<std::string> listed;
    for_each_setting(GetParam().settings, [&](const std::string& path, const Setting&) { listed.insert(path); });
    EXPECT_EQ(listed, leaves);
}

TEST_P(SettingLists, AllowTheirDefaults) {
    EXPECT_EQ(said(GetParam().command, GetParam().defaults), "");
    for_each_setting(GetParam().settings, [&](const std::string& path, const Setting& setting) {
        const Json& standard = setting_at(GetParam().defaults, path);
        if (!standard.is_null()) {  // a null is filled in by a preset later
            expect_allowed(standard, setting.allowed, setting.unit, path);
        }
    });
}

TEST_P(SettingLists, RefuseEveryValueBesideTheRangeNamingTheSetting) {
    std::size_t refused = 0;
    for_each_setting(GetParam().settings, [&](const std::string& path, const Setting& setting) {
        for (const Json& value : refused_by(setting)) {
            Json settings = GetParam().defaults;
            settings[pointer_to(path)] = value;
            EXPECT_THAT(said(GetParam().command, settings),
                        testing::AllOf(testing::HasSubstr(path + ": expected"),
                                       testing::Not(testing::StartsWith("no UsageError"))))
                << value;
            ++refused;
        }
    });
    EXPECT_GT(refused, 10U);
}

TEST_P(SettingLists, SayWhatEachIsInAWholeSentence) {
    for_each_setting(GetParam().settings, [&](const std::string& path, const Setting& setting) {
        EXPECT_GT(setting.meaning.size(), 10U) << path;
        EXPECT_TRUE(setting.meaning.ends_with('.')) << path;
    });
}

INSTANTIATE_TEST_SUITE_P(Commands, SettingLists, testing::ValuesIn(setting_lists()), [](const auto& info) {
    std::string name = info.param.command;
    std::erase(name, '-');
    return name;
});

}  // namespace
}  // namespace ddtool
