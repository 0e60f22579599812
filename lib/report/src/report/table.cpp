#include "report/table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/text.hpp"

namespace ddtool {
namespace {

std::string for_people(const Table::Cell& cell, int decimals) {
    if (const auto* text = std::get_if<std::string>(&cell)) {
        return *text;
    }
    if (const auto* count = std::get_if<std::int64_t>(&cell)) {
        return std::to_string(*count);
    }
    return fixed_text(std::get<double>(cell), decimals);
}

std::string shortest_exact(double number) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.begin(), text.end(), number);
    return {text.begin(), end};
}

std::string csv_field(const Table::Cell& cell) {
    if (const auto* number = std::get_if<double>(&cell)) {
        return std::isnan(*number) ? "" : shortest_exact(*number);
    }
    const std::string text = for_people(cell, 0);
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + "\"";
}

std::string markdown_field(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        escaped += c == '|' ? "\\|" : std::string(1, c);
    }
    return escaped;
}

/// The number of characters of a UTF-8 text. Bytes of the form 10xxxxxx continue a character and are not counted.
std::size_t width(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t to_width, bool to_the_right) {
    const std::string blanks(to_width - width(text), ' ');
    return to_the_right ? blanks + text : text + blanks;
}

}  // namespace

/// The table's texts together with the width of each column.
struct Table::Layout : Table::Words {
    std::vector<std::size_t> widths;

    [[nodiscard]] std::string line(std::size_t index, const std::string& between) const {
        std::string text;
        for (std::size_t column = 0; column < widths.size(); ++column) {
            text += (column == 0 ? "" : between) + padded(lines[index][column], widths[column], numeric[column]);
        }
        return text;
    }
};

Table::Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

void Table::add_row(std::vector<Cell> cells) {
    if (cells.size() != columns_.size()) {
        throw std::invalid_argument("Table::add_row: expected one cell a column");
    }
    rows_.push_back(std::move(cells));
}

bool Table::is_numeric(std::size_t column) const {
    return std::any_of(rows_.begin(), rows_.end(),
                       [&](const auto& row) { return !std::holds_alternative<std::string>(row[column]); });
}

Table::Words Table::words() const {
    Words words;
    words.lines.resize(rows_.size() + 1);
    for (std::size_t column = 0; column < columns_.size(); ++column) {
        words.lines[0].push_back(columns_[column].name);
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            words.lines[row + 1].push_back(for_people(rows_[row][column], columns_[column].decimals));
        }
        words.numeric.push_back(is_numeric(column));
    }
    return words;
}

Table::Layout Table::layout() const {
    Layout layout{words(), {}};
    for (std::size_t column = 0; column < columns_.size(); ++column) {
        std::size_t widest = 0;
        for (const auto& line : layout.lines) {
            widest = std::max(widest, width(line[column]));
        }
        layout.widths.push_back(widest);
    }
    return layout;
}

std::string Table::text() const {
    const Layout layout = this->layout();
    std::string text;
    for (std::size_t index = 0; index < layout.lines.size(); ++index) {
        std::string line = layout.line(index, "  ");
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string Table::markdown() const {
    Layout layout = this->layout();
    std::string rule = "|";
    for (std::size_t column = 0; column < columns_.size(); ++column) {
        std::size_t& widest = layout.widths[column];
        for (auto& line : layout.lines) {
            line[column] = markdown_field(line[column]);
            widest = std::max({widest, width(line[column]), std::size_t{3}});
        }
        rule += " " + std::string(widest - 1, '-') + (layout.numeric[column] ? ":" : "-") + " |";
    }
    std::string text;
    for (std::size_t index = 0; index < layout.lines.size(); ++index) {
        text += "| " + layout.line(index, " | ") + " |\n" + (index == 0 ? rule + "\n" : "");
    }
    return text;
}

std::string Table::csv() const {
    std::string text;
    for (std::size_t column = 0; column < columns_.size(); ++column) {
        text += (column == 0 ? "" : ",") + csv_field(columns_[column].name);
    }
    text += "\n";
    for (const auto& row : rows_) {
        for (std::size_t column = 0; column < row.size(); ++column) {
            text += (column == 0 ? "" : ",") + csv_field(row[column]);
        }
        text += "\n";
    }
    return text;
}

Json Table::json() const {
    Json array = Json::array();
    for (const auto& row : rows_) {
        Json object = Json::object();
        for (std::size_t column = 0; column < row.size(); ++column) {
            std::visit([&](const auto& value) { object[columns_[column].name] = value; }, row[column]);
        }
        array.push_back(std::move(object));
    }
    return array;
}

}  // namespace ddtool
