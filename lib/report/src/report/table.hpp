#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "ddtool/system/settings.hpp"

namespace ddtool {

/// A table with named columns, written for people (as text or Markdown) and for machines (as CSV or JSON).
class Table {
public:
    struct Column {
        std::string name;
        int decimals = 3;  ///< digits after the point in text and Markdown; CSV and JSON have all digits
    };
    /// A text, a measured number or a count. NaN stands for a missing number: it is written as "-" for people, and left
    /// empty (null) for machines.
    using Cell = std::variant<std::string, double, std::int64_t>;

    explicit Table(std::vector<Column> columns);

    /// Adds a row with one cell per column; throws std::invalid_argument for another number of cells.
    void add_row(std::vector<Cell> cells);

    [[nodiscard]] bool empty() const { return rows_.empty(); }

    /// The table in words for people: first the names of the columns, then one line per row, all with the same number
    /// of words.
    struct Words {
        std::vector<std::vector<std::string>> lines;
        std::vector<bool> numeric;  ///< one per column: whether it holds numbers, which are aligned right
    };
    [[nodiscard]] Words words() const;

    /// Columns aligned with blanks, words to the left and numbers to the right. Like the other forms, it ends with a
    /// line break.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::string markdown() const;
    /// RFC 4180, with a header line.
    [[nodiscard]] std::string csv() const;
    /// An array of objects, one per row, with the column names as keys.
    [[nodiscard]] Json json() const;

private:
    struct Layout;
    [[nodiscard]] Layout layout() const;
    [[nodiscard]] bool is_numeric(std::size_t column) const;

    std::vector<Column> columns_;
    std::vector<std::vector<Cell>> rows_;
};

}  // namespace ddtool
