#include "report/montage.hpp"

#include <algorithm>
#include <numeric>

#include "ddtool/base/error.hpp"
#include "report/canvas.hpp"

namespace ddtool::report {
namespace {

constexpr double tile_gap_px = 4.0;
constexpr double strip_px = 22.0;  ///< height of a line of text
constexpr double text_px = 9.0;

struct Group {
    double left_px = 0.0;
    double width_px = 0.0;
};

double width_of(std::size_t pictures, double tile_px) {
    return static_cast<double>(pictures) * (tile_px + tile_gap_px);
}

std::vector<Group> groups_of(const std::vector<std::string>& titles, const std::vector<MontageRow>& rows,
                             double tile_px) {
    std::vector<Group> groups;
    double left_px = tile_gap_px;
    for (std::size_t index = 0; index < titles.size(); ++index) {
        double width_px = Canvas::text_width_px(titles[index], text_px) + tile_gap_px;
        for (const MontageRow& row : rows) {
            width_px = std::max(width_px, width_of(row.groups[index].size(), tile_px));
        }
        groups.push_back({left_px, width_px});
        left_px += width_px + 3.0 * tile_gap_px;
    }
    return groups;
}

}  // namespace

cv::Mat3b montage(const std::vector<std::string>& titles, const std::vector<MontageRow>& rows, double tile_px) {
    if (!std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return row.groups.size() == titles.size(); })) {
        throw Error("montage: a row without a group for each of the " + std::to_string(titles.size()) + " titles");
    }
    const std::vector<Group> groups = groups_of(titles, rows, tile_px);
    double right_px = groups.empty() ? tile_gap_px : groups.back().left_px + groups.back().width_px;
    for (const MontageRow& row : rows) {
        right_px = std::max(right_px, 2.0 * tile_gap_px + Canvas::text_width_px(row.caption, text_px));
    }
    const double row_px = strip_px + tile_px + tile_gap_px;
    Canvas canvas(right_px, strip_px + row_px * static_cast<double>(rows.size()));
    for (std::size_t index = 0; index < groups.size(); ++index) {
        canvas.text({groups[index].left_px, strip_px / 2.0}, titles[index], text_px, Anchor::left);
    }
    double top_px = strip_px;
    for (const MontageRow& row : rows) {
        canvas.text({tile_gap_px, top_px + strip_px / 2.0}, row.caption, text_px, Anchor::left);
        for (std::size_t index = 0; index < groups.size(); ++index) {
            double left_px = groups[index].left_px;
            for (const cv::Mat& picture : row.groups[index]) {
                canvas.picture(picture, {left_px, top_px + strip_px, tile_px, tile_px});
                left_px += tile_px + tile_gap_px;
            }
        }
        top_px += row_px;
    }
    return canvas.page();
}

}  // namespace ddtool::report
