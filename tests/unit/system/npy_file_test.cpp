#include "system/npy_file.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <vector>

#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

using test::TemporaryFolder;
using test::thrown_text;
using testing::HasSubstr;

struct Row {
    double x[3];
    bool operator==(const Row& other) const { return std::equal(x, x + 3, other.x); }
};
const NpyFormat three_columns{"'<f8'", 3};

class NpyFileTest : public ::testing::Test {
protected:
    void write(const std::vector<Row>& rows) {
        write_npy(file_, three_columns, rows.size(), [&](std::ostream& out) {
            const auto bytes = bytes_of(std::span(rows));
            out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        });
    }
    [[nodiscard]] std::string opening(const NpyFormat& format = three_columns) const {
        return thrown_text([&] { const MappedNpy<Row> map(file_, format); });
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "rows.npy";
    std::vector<Row> rows_{{{1.0, -2.0, 1e300}}, {{0.1, 0.2, 0.3}}};
};

TEST_F(NpyFileTest, ThereAndBackKeepsEveryRow) {
    for (const std::size_t count : {0U, 1U, 2U}) {
        const std::vector<Row> rows(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(count));
        write(rows);
        const MappedNpy<Row> map(file_, three_columns);
        EXPECT_THAT(std::vector<Row>(map.rows().begin(), map.rows().end()), testing::ElementsAreArray(rows));
    }
}

TEST_F(NpyFileTest, RowsAreAlignedToACacheLine) {
    write(rows_);
    const MappedNpy<Row> map(file_, three_columns);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(map.rows().data()) % 64, 0U);
}

TEST_F(NpyFileTest, LivesOnWhereItIsMovedTo) {
    write(rows_);
    MappedNpy<Row> map(file_, three_columns);
    const MappedNpy<Row> moved = std::move(map);
    EXPECT_EQ(moved.rows()[1], rows_[1]);
}

TEST_F(NpyFileTest, NamesAFileCutOrGrownAnywhere) {
    write(rows_);
    const std::string whole = read_file(file_);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        write_file(file_, whole.substr(0, size));
        EXPECT_THAT(opening(), HasSubstr("rows.npy")) << size;
    }
    write_file(file_, whole + "x");
    EXPECT_THAT(opening(), HasSubstr("expected " + std::to_string(whole.size())));
}

TEST_F(NpyFileTest, RefusesAnotherType) {
    write(rows_);
    EXPECT_THAT(opening({"'<f4'", 3}), HasSubstr("expected {'descr': '<f4'"));
    EXPECT_THAT(opening({"'<f8'", 2}), HasSubstr("another kind"));
    EXPECT_THAT(opening({"'<f8'", 0}), HasSubstr("another kind"));
}

TEST_F(NpyFileTest, NamesAFileThatIsNotThere) { EXPECT_THAT(opening(), HasSubstr("rows.npy: cannot read: No such")); }

}  // namespace
}  // namespace ddtool
