#include "report/table.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

namespace ddtool {
namespace {

Table small_table() {
    Table table({{"method"}, {"ATE [m]", 2}, {"runs"}});
    table.add_row({"gmapping", 1.23456, std::int64_t{10}});
    table.add_row({"a|b, \"c\" ±", std::nan(""), std::int64_t{5}});
    return table;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

TEST(Table, AsTextIsAligned) {
    EXPECT_EQ(small_table().text(),
              "method      ATE [m]  runs\n"
              "gmapping       1.23    10\n"
              "a|b, \"c\" ±        -     5\n");
}

TEST(Table, HasItsWords) {
    const Table::Words words = small_table().words();
    EXPECT_THAT(words.numeric, testing::ElementsAre(false, true, true));
    EXPECT_THAT(words.lines, testing::ElementsAre(testing::ElementsAre("method", "ATE [m]", "runs"),
                                                  testing::ElementsAre("gmapping", "1.23", "10"),
                                                  testing::ElementsAre("a|b, \"c\" ±", "-", "5")));
}

TEST(Table, AsMarkdownHasTheSameColumnsInEveryLine) {
    const std::vector<std::string> lines = lines_of(small_table().markdown());
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0], "| method      | ATE [m] | runs |");
    EXPECT_EQ(lines[1], "| ----------- | ------: | ---: |");
    EXPECT_EQ(lines[2], "| gmapping    |    1.23 |   10 |");
    EXPECT_EQ(lines[3], "| a\\|b, \"c\" ± |       - |    5 |");
}

TEST(Table, AsCsvKeepsAllDigitsAndQuotes) {
    EXPECT_EQ(small_table().csv(),
              "method,ATE [m],runs\n"
              "gmapping,1.23456,10\n"
              "\"a|b, \"\"c\"\" ±\",,5\n");
}

TEST(Table, AsJsonHasTheRows) {
    const Json rows = small_table().json();
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0]["ATE [m]"], 1.23456);
    EXPECT_EQ(rows[0]["runs"], 10);
    EXPECT_EQ(Json::parse(rows.dump())[1]["ATE [m]"], nullptr);
}

TEST(Table, WithoutRowsHasItsHeader) {
    const Table table({{"a"}, {"b"}});
    EXPECT_EQ(table.text(), "a  b\n");
    EXPECT_EQ(table.csv(), "a,b\n");
}

TEST(Table, RefusesARowOfAnotherLength) {
    Table table({{"a"}, {"b"}});
    EXPECT_THROW(table.add_row({1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace ddtool
