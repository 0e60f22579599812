#include "study/compare/experiment.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "base/pattern.hpp"
#include "ddtool/base/error.hpp"
#include "methods/settings_json.hpp"
#include "sim/simulation_json.hpp"
#include "system/fingerprint.hpp"
#include "system/log.hpp"
#include "system/seed_range.hpp"

namespace ddtool::compare {
namespace {

/// Part of every cell's key. It is increased when earlier results can no longer be compared with new ones.
constexpr int format = 1;

struct ScoreSettings {
    std::string align = "se2";
    double max_time_difference_s = default_max_time_difference_s;
};

template <typename Entry, typename... Context>
std::vector<Entry> entries_from(const Json& settings, const std::string& list, const std::string& common,
                                const Context&... context) {
    std::vector<Entry> entries;
    std::set<std::string> names;
    for (const Json& item : settings.at(list)) {
        const std::string where = list + "[" + std::to_string(entries.size()) + "]";
        entries.emplace_back(item, settings.at(common), where, context...);
        if (!names.insert(file_name_of(entries.back().name())).second) {
            throw UsageError(where + ": the name '" + entries.back().name() + "' was given before");
        }
    }
    if (entries.empty()) {
        throw UsageError(list + ": expected one or more");
    }
    return entries;
}

void leave_out_absent(Experiment& experiment) {
    std::vector<std::string> worlds;
    for (const WorldEntry& world : experiment.worlds) {
        worlds.push_back(world.name());
    }
    std::erase_if(experiment.contestants, [&](const Contestant& contestant) {
        const bool absent = contestant.is_absent(worlds, experiment.seeds);
        if (absent) {
            log_info(contestant.name() + ": none of its trajectories is there, left out");
        }
        return absent;
    });
}

std::array<double, 3> printed_errors(const Json& json, const std::string& where) {
    std::array<double, 3> errors_m{};
    errors_m.fill(std::numeric_limits<double>::quiet_NaN());
    if (json.is_null()) {
        return errors_m;
    }
    const auto is_number = [](const Json& each) { return each.is_number(); };
    if (!json.is_array() || json.size() != errors_m.size() || !std::ranges::all_of(json, is_number)) {
        throw UsageError(where + ": expected ATE, Error_x and Error_y in metres, or null, not " + json.dump());
    }
    return json.get<std::array<double, 3>>();
}

/// The printed errors of the experiment's own worlds, so that a part of its worlds can be run without the others.
std::vector<PrintedErrors> paper_from(const Json& list, const std::vector<WorldEntry>& worlds) {
    std::vector<PrintedErrors> paper;
    for (std::size_t place = 0; place < list.size(); ++place) {
        const std::string where = "paper[" + std::to_string(place) + "]";
        const Json& item = list[place];
        if (!item.is_object() || !item.contains("world") || !item.contains("errors_m") ||
            !item.at("errors_m").is_object() || item.size() != 2) {
            throw UsageError(where + R"(: expected {"world": NAME, "errors_m": {METHOD: [ATE, Error_x, Error_y]}})");
        }
        const std::string world = item.at("world");
        const bool is_run = std::ranges::find(worlds, world, &WorldEntry::name) != worlds.end();
        for (const auto& [method, errors] : item.at("errors_m").items()) {
            const std::array<double, 3> errors_m = printed_errors(errors, where + ".errors_m." + method);
            if (is_run) {
                paper.push_back({world, method, errors_m});
            }
        }
    }
    return paper;
}

std::size_t baseline_from(const std::string& name, const std::vector<Contestant>& contestants) {
    std::vector<std::string> names;
    for (const Contestant& contestant : contestants) {
        if (name.empty() || contestant.name() == name) {
            return names.size();
        }
        names.push_back(contestant.name());
    }
    throw UsageError("baseline: unknown method '" + name + "'; did you mean: " + joined(nearest_words(name, names)) +
                     "?");
}

const SettingTable<ScoreSettings>& score_rows() {
    static const SettingTable<ScoreSettings> rows{
        {"align", &ScoreSettings::align, Allowed::one_of({"none", "first", "se2"}), "",
         "How a trajectory is aligned with the reference before it is scored.", "docs/scoring.md"},
        {"max_time_difference_s", &ScoreSettings::max_time_difference_s, Allowed::number(0.0, 3600.0), "s",
         "Poses are compared with those of the reference that are no farther away in time."},
    };
    return rows;
}

AteOptions score_from(const Json& json) {
    const ScoreSettings settings = score_rows().checked(json, "score");
    return {.alignment = parse_alignment(settings.align), .max_time_difference_s = settings.max_time_difference_s};
}

/// The scoring options in the form in which they enter the key of a cell.
Json score_identity(const AteOptions& options) {
    return {{"align", static_cast<int>(options.alignment)}, {"max_time_difference_s", options.max_time_difference_s}};
}

}  // namespace

std::vector<Setting> experiment_setting_list() {
    return {
        {"worlds", Allowed::other(), "", "Where the methods run: names of worlds, or objects.", "docs/compare.md", {}},
        {"methods", Allowed::other(), "", "What is compared: a list of objects.", "docs/compare.md", {}},
        {"baseline",
         Allowed::text(),
         "",
         "Name of the method that the others are tested against; empty for the first.",
         "",
         {}},
        {"seeds", {}, "", "", "", seed_range_setting_list()},
        {"simulation", {}, "", "", "", sim::common_simulation_setting_list()},
        {"filter", {}, "", "", "", without(filter_setting_list(), "seed")},
        {"score", {}, "", "", "", score_rows().settings()},
        {"paper",
         Allowed::other(),
         "",
         "What a publication prints for methods in these worlds: a list of objects.",
         "docs/compare.md",
         {}}};
}

Json default_experiment_json() {
    return {{"worlds", Json::array()},
            {"methods", Json::array()},
            {"baseline", ""},
            {"seeds", {{"first", 1U}, {"count", 10U}}},
            {"simulation", sim::common_simulation_json()},
            {"filter", common_filter_json()},
            {"score", score_rows().json({})},
            {"paper", Json::array()}};
}

Experiment experiment_from_json(const Json& settings, const DetectorTable& detectors) {
    Experiment experiment{.worlds = entries_from<WorldEntry>(settings, "worlds", "simulation"),
                          .contestants = entries_from<Contestant>(settings, "methods", "filter", detectors),
                          .seeds = seeds_from_json(settings.at("seeds"), "seeds"),
                          .score = score_from(settings.at("score")),
                          .paper = {}};
    leave_out_absent(experiment);
    experiment.paper = paper_from(settings.at("paper"), experiment.worlds);
    experiment.baseline = baseline_from(settings.at("baseline").get<std::string>(), experiment.contestants);
    return experiment;
}

std::vector<Cell> cells_of(const Experiment& experiment) {
    std::vector<Cell> cells;
    for (std::size_t seed = 0; seed < experiment.seeds.size(); ++seed) {
        for (std::size_t world = 0; world < experiment.worlds.size(); ++world) {
            const WorldEntry& entry = experiment.worlds[world];
            const auto data = std::make_shared<const DataSource>(entry.data(experiment.seeds[seed]));
            const std::string data_id = Fingerprint().add(data->identity.dump()).hex();
            for (std::size_t contestant = 0; contestant < experiment.contestants.size(); ++contestant) {
                const Json identity = experiment.contestants[contestant].identity(entry.name(), experiment.seeds[seed]);
                jobs::Key key(Json{{"format", format},
                                   {"data", data->identity},
                                   {"method", identity},
                                   {"score", score_identity(experiment.score)}});
                cells.push_back({world, contestant, seed, data, std::move(key), data_id});
            }
        }
    }
    return cells;
}

std::string title_of(const Experiment& experiment, const Cell& cell) {
    return experiment.worlds[cell.world].name() + " / " + experiment.contestants[cell.contestant].name() + " / seed " +
           std::to_string(experiment.seeds[cell.seed]);
}

}  // namespace ddtool::compare
