#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "callable_detector.hpp"
#include "ddtool/base/thread_pool.hpp"
#include "ddtool/filter/scan_odometry.hpp"
#include "ddtool/methods/method.hpp"
#include "ddtool/robot/scan_truth.hpp"
#include "ddtool/system/settings.hpp"
#include "localization/localizer.hpp"
#include "py.hpp"
#include "scan.hpp"

namespace ddtool::python {

/// An update as Python sees it.
struct HeldUpdate {
    Update update;
    double direction_rad = 0.0;
    std::optional<localization::Standing> standing;
};

/// A stream of the one frame that is handed to it.
class HandedFrame : public SensorStream {
public:
    void hand(const SensorFrame& frame) { frame_ = frame; }
    std::optional<SensorFrame> next() override { return std::exchange(frame_, std::nullopt); }
    [[nodiscard]] double fraction_read() const override { return 0.0; }

private:
    std::optional<SensorFrame> frame_;
};

/// A detector as it is given in Python: a name, a callable, or nothing for the method's own.
struct GivenDetector {
    std::string name;
    std::shared_ptr<CallableDetector> callable;
};
GivenDetector detector_from(const py::object& given);

/// Makes a filter for settings with detectors on threads.
using FilterMaker =
    std::function<std::unique_ptr<ParticleFilter>(const FilterSettings&, const DetectorTable&, ThreadPool&)>;

/// A filter that Python feeds scan by scan, with what it needs: threads, the odometry that its scans complete, the
/// truth of simulated scans. Several Python threads may use it; they wait for each other.
class Run {
public:
    /// \param settings of the filter; a callable takes the place of their detector
    Run(FilterSettings settings, Json all_settings, const GivenDetector& detector, std::size_t threads,
        const FilterMaker& make);
    ~Run();
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    /// Null where the filter made none. Throws what the detector threw.
    std::shared_ptr<HeldUpdate> update(const HeldScan& scan);

    /// Runs work(filter), without the GIL, while no other thread uses the filter. Throws Error before the first scan.
    template <typename Work>
    auto with_filter(Work&& work) {
        expect_usable();
        const py::gil_scoped_release release;
        const Turn turn(*this);
        if (!has_scan_) {
            throw Error("no scan yet: call update() or run() first");
        }
        return work(std::as_const(*filter_));
    }

    [[nodiscard]] const Json& settings() const { return all_settings_; }
    [[nodiscard]] const std::shared_ptr<CallableDetector>& callable() const { return callable_; }

private:
    /// The filter for one thread.
    class Turn {
    public:
        explicit Turn(Run& run) : lock_(run.mutex_), user_(run.user_) { user_ = std::this_thread::get_id(); }
        ~Turn() { user_ = std::thread::id(); }
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;

    private:
        std::lock_guard<std::mutex> lock_;
        std::atomic<std::thread::id>& user_;
    };

    void expect_usable() const;
    std::optional<Update> filtered(const HeldScan& scan);

    Json all_settings_;
    std::shared_ptr<CallableDetector> callable_;
    std::shared_ptr<ScanTruth> truth_ = std::make_shared<ScanTruth>();
    std::unique_ptr<ThreadPool> threads_;
    std::unique_ptr<ParticleFilter> filter_;
    HandedFrame handed_;
    std::unique_ptr<ScanOdometryStream> odometry_;
    std::mutex mutex_;
    std::atomic<std::thread::id> user_;  ///< of the filter, now
    int process_;                        ///< that the threads belong to
    bool has_scan_ = false;
    std::string broken_;  ///< why the filter cannot go on; empty: it can
};

/// Registers ddtool.Slam, Localizer, localize(), Update and Standing.
void add_runs(py::module_& module);

}  // namespace ddtool::python
