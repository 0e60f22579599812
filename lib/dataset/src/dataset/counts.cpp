#include "dataset/counts.hpp"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace ddtool::dataset {
namespace {

Json by_class(std::span<const SampleRecord> records, LabelRule rule, const auto& counts) {
    Json json;
    for (const Label label : {Label::degenerate, Label::not_degenerate}) {
        json[class_names[index_of(label)]] = std::count_if(records.begin(), records.end(), [&](const auto& record) {
            return record.label_of(rule) == label && counts(record);
        });
    }
    return json;
}

std::string line_of(std::initializer_list<std::string_view> words) {
    std::string line;
    for (const std::string_view word : words) {
        line += word;
    }
    return line;
}

}  // namespace

Json counts_of(std::span<const SampleRecord> candidates, const BalanceSettings& wanted) {
    Json json;
    for (const LabelRule rule : {LabelRule::dispersion, LabelRule::fisher}) {
        Json& of_rule = json[label_rule_names[index_of(rule)]];
        of_rule["wanted"] = {{class_names[1], wanted.degenerate}, {class_names[0], wanted.not_degenerate}};
        of_rule["candidates"] = by_class(candidates, rule, [](const SampleRecord&) { return true; });
        for (const Split split : {Split::paper, Split::held_out}) {
            for (const Part part : {Part::train, Part::validation, Part::test}) {
                of_rule[split_names[index_of(split)]][part_names[index_of(part)]] = by_class(
                    candidates, rule, [&](const SampleRecord& record) { return record.part_of(rule, split) == part; });
            }
        }
    }
    return json;
}

void expect_counts(const Json& counts) {
    const auto expect_classes = [](const Json& by_class) {
        for (const char* name : class_names) {
            (void)by_class.at(name).get<std::uint64_t>();
        }
    };
    for (const auto& [rule, of_rule] : counts.items()) {
        expect_classes(of_rule.at("candidates"));
        for (const auto& [name, wanted] : of_rule.at("wanted").items()) {
            (void)of_rule.at("candidates").at(name);
        }
        for (const char* split : split_names) {
            for (const auto& [part, by_class] : of_rule.at(split).items()) {
                expect_classes(by_class);
            }
        }
    }
}

std::vector<std::string> shortages_in(const Json& counts) {
    std::vector<std::string> lines;
    for (const auto& [rule, of_rule] : counts.items()) {
        for (const auto& [name, wanted] : of_rule.at("wanted").items()) {
            const Json& found = of_rule.at("candidates").at(name);
            if (found < wanted) {
                lines.push_back(line_of({"label ", rule, ": ", found.dump(), " samples are ", name, ", wanted ",
                                         wanted.dump(), "; all are taken"}));
            }
        }
        for (const char* split : split_names) {
            for (const auto& [part, by_class] : of_rule.at(split).items()) {
                if (by_class.at(class_names[0]) == 0 || by_class.at(class_names[1]) == 0) {
                    lines.push_back(line_of({"label ", rule, ", split ", split, ": ", part, " lacks a class"}));
                }
            }
        }
    }
    return lines;
}

}  // namespace ddtool::dataset
