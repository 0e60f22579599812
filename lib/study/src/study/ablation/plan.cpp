#include "study/ablation/plan.hpp"

#include <algorithm>

#include "ddtool/base/error.hpp"

namespace ddtool::ablation {
namespace {

const Allowed timed_samples = Allowed::whole(1, 1e6);

/// Every setting of a training except the seed.
Json default_training() {
    // a named object, because GCC 12 warns that a temporary might be used uninitialised
    const train::TrainSettings defaults;
    Json json = defaults;
    json.erase("seed");
    return json;
}

/// The number, or NaN for null. null stands for a dash in the paper's table.
double figure(const Json& json, const std::string& where) {
    if (!json.is_null() && !json.is_number()) {
        throw UsageError(where + ": expected a number or null, not " + json.dump());
    }
    return json.is_null() ? not_printed : json.get<double>();
}

const Json no_printed_figures = {{"accuracy", nullptr}, {"f1", nullptr}};

Printed printed_from(const Json& json, const std::string& where) {
    return {figure(json.at("accuracy"), where + ".accuracy"), figure(json.at("f1"), where + ".f1")};
}

Row row_from(const Json& item, const Json& common, const std::string& where) {
    Json known{{"name", ""}, {"train", common}, {"paper", no_printed_figures}};
    merge_settings(known, item, where);
    known["train"]["seed"] = 0U;
    Row row{known.at("name"), train::train_settings_from_json(known.at("train"), where + ".train"),
            printed_from(known.at("paper"), where + ".paper")};
    if (row.name.empty()) {
        throw UsageError(where + ".name: expected a name");
    }
    return row;
}

RuleRow rule_from(const Json& item, const std::string& where) {
    Json known{{"rule", ""}, {"swarm", ""}, {"paper", no_printed_figures}};
    merge_settings(known, item, where);
    return {known.at("rule"), known.at("swarm"), printed_from(known.at("paper"), where + ".paper")};
}

Timing timing_from(const Json& item, const std::vector<Row>& rows, const std::string& where) {
    const Timing defaults;
    Json known{{"row", ""}, {"device", defaults.device}, {"image_file", defaults.image_file}, {"paper_ms", nullptr}};
    merge_settings(known, item, where);
    const auto name = known.at("row").get<std::string>();
    const auto row = std::ranges::find(rows, name, &Row::name);
    if (row == rows.end()) {
        throw UsageError(where + ".row: expected the name of a row, not '" + name + "'");
    }
    return {static_cast<std::size_t>(row - rows.begin()), known.at("device"), known.at("image_file"),
            figure(known.at("paper_ms"), where + ".paper_ms")};
}

std::string place(const std::string& list, std::size_t index) { return list + "[" + std::to_string(index) + "]"; }

}  // namespace

std::vector<Setting> plan_setting_list() {
    return {
        {"seeds", Allowed::other(), "", "Each row is trained once with each of these seeds: a list.", "", {}},
        {"train", {}, "", "", "", without(train::train_setting_list(), "seed")},
        {"rows", Allowed::other(), "", "The trainings, and what the paper prints for each.", "docs/evaluation.md", {}},
        {"rules", Allowed::other(), "", "Simple rules beside the trainings.", "docs/evaluation.md", {}},
        {"timings", Allowed::other(), "", "The ways of running a network that are timed.", "docs/evaluation.md", {}},
        {"timed_samples", timed_samples, "", "Number of snapshots that a timing takes its median of.", "", {}}};
}

Json default_plan_json() {
    return {{"seeds", {1U, 2U, 3U}},  {"train", default_training()}, {"rows", Json::array()},
            {"rules", Json::array()}, {"timings", Json::array()},    {"timed_samples", 200U}};
}

Plan plan_from_json(const Json& json) {
    expect_allowed(json, plan_setting_list(), "");
    Plan plan;
    plan.seeds = json.at("seeds").get<std::vector<std::uint64_t>>();
    plan.timed_samples = json.at("timed_samples");
    for (const Json& item : json.at("rows")) {
        plan.rows.push_back(row_from(item, json.at("train"), place("rows", plan.rows.size())));
    }
    for (const Json& item : json.at("rules")) {
        plan.rules.push_back(rule_from(item, place("rules", plan.rules.size())));
    }
    for (const Json& item : json.at("timings")) {
        plan.timings.push_back(timing_from(item, plan.rows, place("timings", plan.timings.size())));
    }
    if (plan.seeds.empty() || plan.rows.empty()) {
        throw UsageError("ablation: expected one or more seeds and rows");
    }
    return plan;
}

}  // namespace ddtool::ablation
