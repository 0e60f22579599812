#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "ddtool/filter/scan_odometry.hpp"
#include "ddtool/logs/log_stream.hpp"
#include "ddtool/robot/joined_scans.hpp"

namespace ddtool {

/// The scans of a log, those of several lidars joined, together with an odometry: the log's own, completed from the
/// scans where it does not tell the motion, or one made from the scans if the log has none.
class DrivenScans : public SensorStream {
public:
    /// settings: those of the filter that will process the frames.
    DrivenScans(std::unique_ptr<LogStream> log, const RbpfSettings& settings)
        : log_(std::move(log)), joined_(*log_), completed_(joined_, settings) {}
    std::optional<SensorFrame> next() override { return completed_.next(); }
    [[nodiscard]] double fraction_read() const override { return log_->fraction_read(); }
    void tell_truth(const std::shared_ptr<ScanTruth>& truth) override { log_->tell_truth(truth); }
    [[nodiscard]] const LogSummary& summary() const { return log_->summary(); }

private:
    std::unique_ptr<LogStream> log_;
    JoinedScans joined_;
    ScanOdometryStream completed_;
};

}  // namespace ddtool
