#include "run.hpp"

#include <sys/types.h>
#include <unistd.h>

#include <exception>

#include "ddtool/base/error.hpp"
#include "ddtool/swarm/swarm_shape.hpp"
#include "host.hpp"
#include "system/failure_text.hpp"

namespace ddtool::python {
namespace {

/// Under this name a callable is in the table of detectors.
constexpr const char* callable_name = "callable";

}  // namespace

GivenDetector detector_from(const py::object& given) {
    if (given.is_none()) {
        return {};
    }
    if (py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__")) {
        return {expect_model_file(py::module_::import("os").attr("fspath")(given).cast<std::string>()), nullptr};
    }
    if (PyCallable_Check(given.ptr()) == 0) {
        throw py::type_error("detector: expected a name or a callable, not " +
                             py::repr(py::type::of(given)).cast<std::string>());
    }
    return {"", std::make_shared<CallableDetector>(given)};
}

Run::Run(FilterSettings settings, Json all_settings, const GivenDetector& detector, std::size_t threads,
         const FilterMaker& make)
    : all_settings_(std::move(all_settings)), callable_(detector.callable), process_(::getpid()) {
    constexpr std::size_t most_threads = 1024;  // more than any machine has cores, and few enough to be started
    if (threads > most_threads) {
        throw UsageError("threads: expected a number from 0 to " + std::to_string(most_threads) + ", not " +
                         std::to_string(threads));
    }
    DetectorTable detectors;
    detectors.know(truth_);
    if (callable_) {
        detectors.add(callable_name,
                      [asked = callable_.get()](const ParticleSnapshot& swarm) { return asked->ask(swarm); });
        settings.method.parts.detector = callable_name;
    }
    without_gil([&] {
        threads_ = std::make_unique<ThreadPool>(threads);
        filter_ = make(settings, detectors, *threads_);
        odometry_ = std::make_unique<ScanOdometryStream>(handed_, settings.rbpf);
    });
}

Run::~Run() {
    // In a child of fork() the threads of the pool do not exist, and waiting for their end would never end.
    if (::getpid() != process_ && threads_->size() > 1) {
        static_cast<void>(filter_.release());
        static_cast<void>(threads_.release());
    }
}

void Run::expect_usable() const {
    if (::getpid() != process_ && threads_->size() > 1) {
        throw Error(
            "this object was made before os.fork(), and its threads are in the parent; make it in the child, or "
            "with threads=1");
    }
    if (user_.load() == std::this_thread::get_id()) {
        throw Error("a detector cannot use the object that asks it; the Swarm that it gets has all that it may use");
    }
}

std::optional<Update> Run::filtered(const HeldScan& scan) {
    if (!broken_.empty()) {
        throw Error("cannot go on: " + broken_);
    }
    if (scan.fisher_information) {
        truth_->add(scan.frame.scan.stamp_ns, *scan.fisher_information);
    }
    try {
        handed_.hand(scan.frame);
        std::optional<Update> update = filter_->update(*odometry_->next());
        has_scan_ = true;
        return update;
    } catch (const std::exception& failure) {
        // The particles may have been moved already, so that there is no state to go on from; the path and the map up
        // to here stay.
        broken_ = failure_text(failure);
        throw;
    }
}

std::shared_ptr<HeldUpdate> Run::update(const HeldScan& scan) {
    expect_usable();
    std::shared_ptr<HeldUpdate> made;
    std::optional<double> direction_rad;
    {
        const py::gil_scoped_release release;
        const Turn turn(*this);
        std::optional<Update> update = filtered(scan);
        direction_rad = callable_ ? callable_->take_direction() : std::nullopt;
        if (update) {
            made = std::make_shared<HeldUpdate>();
            made->update = *std::move(update);
            made->direction_rad = direction_rad.value_or(
                swarm_shape(made->update.matched.particles, &SnapshotParticle::pose).major_direction_rad);
            if (const auto* const localizer = dynamic_cast<const localization::Localizer*>(filter_.get())) {
                made->standing = localizer->standing();
            }
        }
    }
    if (callable_) {
        callable_->raise_failure();
    }
    return made;
}

}  // namespace ddtool::python
