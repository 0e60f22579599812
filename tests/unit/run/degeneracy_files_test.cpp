#include "run/degeneracy_files.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <span>
#include <sstream>

#include "small_run.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

std::vector<UpdateSummary> reports_of_a_run() {
    test::SmallRun small;
    std::vector<UpdateSummary> reports;
    small.run([&](const SensorFrame&, const std::optional<Update>& update) {
        if (update) {
            reports.push_back(summary_of(*update));
        }
        return true;
    });
    return reports;
}

std::vector<std::vector<double>> rows_of(const std::string& csv, std::size_t& columns) {
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    columns = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
    std::vector<std::vector<double>> rows;
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        std::vector<double>& row = rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, ',');) {
            row.push_back(std::stod(cell));
        }
    }
    return rows;
}

TEST(DegeneracyCsv, HasARowAnUpdateAndAllColumns) {
    const std::vector<UpdateSummary> reports = reports_of_a_run();
    ASSERT_GT(reports.size(), 20U);
    const test::TemporaryFolder folder;
    DegeneracyCsv csv(folder / "degeneracy.csv");
    std::for_each(reports.begin(), reports.end(), [&](const UpdateSummary& report) { csv.add(report); });
    EXPECT_FALSE(std::filesystem::exists(folder / "degeneracy.csv"));
    csv.close();
    std::size_t columns = 0;
    const auto rows = rows_of(read_file(folder / "degeneracy.csv"), columns);
    ASSERT_EQ(rows.size(), reports.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ASSERT_EQ(rows[i].size(), columns);
        EXPECT_NEAR(rows[i][8], reports[i].pose.x_m, 1e-6);
        EXPECT_NEAR(rows[i].back(), reports[i].covariance(2, 2), 1e-9);
    }
}

TEST(UpdateSummary, CovarianceIsOneAndSmallInARoom) {
    const std::vector<UpdateSummary> reports = reports_of_a_run();
    EXPECT_EQ(reports.front().covariance.norm(), 0.0) << "the map begins where the robot is";
    for (const UpdateSummary& report : std::span(reports).subspan(1)) {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(report.covariance);
        EXPECT_GT(axes.eigenvalues()(0), 0.0);
        EXPECT_LT(std::sqrt(report.covariance(0, 0) + report.covariance(1, 1)), 0.1);
        EXPECT_TRUE(report.covariance.isApprox(report.covariance.transpose()));
    }
}

TEST(DegeneracyPicture, IsDrawnOfAnyRun) {
    const test::TemporaryFolder folder;
    write_degeneracy_picture(folder / "none.png", {}, map_raster(OccupancyGrid(OccupancySettings{})), {});
    UpdateSummary report;
    report.stamp_ns = 5;
    write_degeneracy_picture(folder / "one.png", {report}, map_raster(OccupancyGrid(OccupancySettings{})), {{5, {}}});
    EXPECT_GT(std::filesystem::file_size(folder / "none.png"), 100U);
    EXPECT_NE(read_file(folder / "one.png"), read_file(folder / "none.png"));
}

}  // namespace
}  // namespace ddtool
