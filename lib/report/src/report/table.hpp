#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "ddtool/system/settings.hpp"

namespace ddtool {

/// Rows under named columns, for people (text, Markdown) and for machines (CSV, JSON).
class Table {
public:
    struct Column {
        std::string name;
        int decimals = 3;  ///< of its numbers in text and Markdown; machines get all digits
    };
    /// Text, a measured number or a count. NaN is a number that is missing: "-" for people, nothing for machines.
    using Cell = std::variant<std::string, double, std::int64_t>;

    explicit Table(std::vector<Column> columns);

    /// One cell a column; throws std::invalid_argument otherwise.
    void add_row(std::vector<Cell> cells);

    [[nodiscard]] bool empty() const { return rows_.empty(); }

    /// What people read: the columns' names first, then a line a row, all of the same length.
    struct Words {
        std::vector<std::vector<std::string>> lines;
        std::vector<bool> numeric;  ///< one a column: numbers, to be set to the right
    };
    [[nodiscard]] Words words() const;

    /// Columns aligned with blanks: words to the left, numbers to the right. Ends with a line break, as all do.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::string markdown() const;
    /// RFC 4180, with a header line.
    [[nodiscard]] std::string csv() const;
    /// An array of objects, one a row, with the column names as keys.
    [[nodiscard]] Json json() const;

private:
    struct Layout;
    [[nodiscard]] Layout layout() const;
    [[nodiscard]] bool is_numeric(std::size_t column) const;

    std::vector<Column> columns_;
    std::vector<std::vector<Cell>> rows_;
};

}  // namespace ddtool
