#include "dataset/counts.hpp"

#include <algorithm>

#include "ddtool/system/json_struct.hpp"

namespace ddtool::dataset {

DDTOOL_JSON_STRUCT(ClassCounts, degenerate, not_degenerate)

namespace {

ClassCounts by_class(std::span<const SampleRecord> records, LabelRule rule, const auto& counts) {
    const auto count = [&](Label label) {
        return static_cast<std::uint64_t>(std::count_if(records.begin(), records.end(), [&](const auto& record) {
            return record.label_of(rule) == label && counts(record);
        }));
    };
    return {count(Label::degenerate), count(Label::not_degenerate)};
}

void add_shortage(std::vector<std::string>& lines, LabelRule rule, Label label, std::uint64_t found,
                  std::uint64_t wanted) {
    if (found < wanted) {
        lines.push_back("label " + name_of(rule) + ": " + std::to_string(found) + " samples are " +
                        class_names[index_of(label)] + ", wanted " + std::to_string(wanted) + "; all are taken");
    }
}

}  // namespace

void to_json(Json& json, const Counts& counts) {
    json = Json::object();
    for (const LabelRule rule : all_label_rules) {
        Json& of_rule = json[name_of(rule)];
        of_rule["wanted"] = counts.of(rule).wanted;
        of_rule["candidates"] = counts.of(rule).candidates;
        for (const Split split : all_splits) {
            for (const Part part : used_parts) {
                of_rule[name_of(split)][name_of(part)] = counts.of(rule).of(split, part);
            }
        }
    }
}

void from_json(const Json& json, Counts& counts) {
    for (const LabelRule rule : all_label_rules) {
        const Json& of_rule = json.at(name_of(rule));
        of_rule.at("wanted").get_to(counts.of(rule).wanted);
        of_rule.at("candidates").get_to(counts.of(rule).candidates);
        for (const Split split : all_splits) {
            for (const Part part : used_parts) {
                of_rule.at(name_of(split)).at(name_of(part)).get_to(counts.of(rule).of(split, part));
            }
        }
    }
}

Counts counts_of(std::span<const SampleRecord> candidates, const BalanceSettings& wanted) {
    Counts counts;
    for (const LabelRule rule : all_label_rules) {
        RuleCounts& of_rule = counts.of(rule);
        of_rule.wanted = {wanted.degenerate, wanted.not_degenerate};
        of_rule.candidates = by_class(candidates, rule, [](const SampleRecord&) { return true; });
        for (const Split split : all_splits) {
            for (const Part part : used_parts) {
                of_rule.of(split, part) = by_class(
                    candidates, rule, [&](const SampleRecord& record) { return record.part_of(rule, split) == part; });
            }
        }
    }
    return counts;
}

std::vector<std::string> shortages_in(const Counts& counts) {
    std::vector<std::string> lines;
    for (const LabelRule rule : all_label_rules) {
        const auto& [wanted, candidates, chosen] = counts.of(rule);
        add_shortage(lines, rule, Label::degenerate, candidates.degenerate, wanted.degenerate);
        add_shortage(lines, rule, Label::not_degenerate, candidates.not_degenerate, wanted.not_degenerate);
        for (const Split split : all_splits) {
            for (const Part part : used_parts) {
                const ClassCounts& found = counts.of(rule).of(split, part);
                if (found.degenerate == 0 || found.not_degenerate == 0) {
                    lines.push_back("label " + name_of(rule) + ", split " + name_of(split) + ": " + name_of(part) +
                                    " lacks a class");
                }
            }
        }
    }
    return lines;
}

}  // namespace ddtool::dataset
