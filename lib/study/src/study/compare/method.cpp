#include "study/compare/method.hpp"

#include "base/pattern.hpp"
#include "ddtool/base/error.hpp"
#include "ddtool/base/thread_pool.hpp"
#include "methods/settings_json.hpp"
#include "scores/tum_file.hpp"
#include "study/compare/known_map.hpp"
#include "system/fingerprint.hpp"

namespace ddtool::compare {
namespace {

class OdometryMethod : public Method {
public:
    void process(const SensorFrame& frame) override {
        trajectory_.push_back({frame.scan.stamp_ns, frame.odom_from_robot});
    }
    Trajectory trajectory() override { return trajectory_; }

private:
    Trajectory trajectory_;
};

/// On one thread: the comparison runs many at once.
class FilterMethod : public Method {
public:
    FilterMethod(const FilterSettings& settings, const DetectorTable& detectors)
        : filter_(make_filter(settings, detectors, threads_)) {}
    void process(const SensorFrame& frame) override { filter_->update(frame); }
    Trajectory trajectory() override { return filter_->trajectory(); }

private:
    ThreadPool threads_{1};
    std::unique_ptr<Rbpf> filter_;
};

/// What another program made of the same log.
class ExternalMethod : public Method {
public:
    explicit ExternalMethod(std::string file) : file_(std::move(file)) {}
    void process(const SensorFrame& /*frame*/) override {}
    Trajectory trajectory() override { return read_tum(file_); }

private:
    std::string file_;
};

Json method_defaults(const std::string& kind, const Json& filter, const std::string& where) {
    if (kind == "filter") {
        return {{"name", ""}, {"kind", kind}, {"filter", filter}};
    }
    if (kind == "odometry") {
        return {{"name", ""}, {"kind", kind}};
    }
    if (kind == "external") {
        return {{"name", ""}, {"kind", kind}, {"trajectories", ""}};
    }
    if (kind == "known-map") {
        return {{"name", ""}, {"kind", kind}, {"odometry", "typical"}};
    }
    throw UsageError(where + ": kind '" + kind + "': expected filter, odometry, external or known-map");
}

FilterSettings filter_settings(const Json& method, std::uint64_t seed) {
    Json filter = method.at("filter");
    filter["seed"] = seed;
    return filter_settings_from_json(filter);
}

/// The kind that an item names; "filter" where it names none.
std::string kind_of(const Json& item) {
    const bool named = item.is_object() && item.contains("kind") && item.at("kind").is_string();
    return named ? item.at("kind").get<std::string>() : "filter";
}

}  // namespace

MethodEntry::MethodEntry(const Json& item, const Json& filter, const std::string& where, DetectorTable detectors)
    : kind_(kind_of(item)), settings_(method_defaults(kind_, filter, where)), detectors_(std::move(detectors)) {
    merge_settings(settings_, item, where);
    name_ = settings_.at("name").get<std::string>();
    if (name_.empty()) {
        throw UsageError(where + ": expected a name");
    }
    if (kind_ == "filter") {
        ThreadPool one(1);
        (void)make_filter(filter_settings(settings_, 0), detectors_,
                          one);  // what makes no sense shows now, not in every run
    }
    if (kind_ == "known-map") {
        (void)sim::odometry_preset(settings_.at("odometry"));
    }
    if (kind_ == "external" && settings_.at("trajectories").get<std::string>().empty()) {
        throw UsageError(where + ": expected trajectories, the path of TUM files with {world} and {seed} in it");
    }
}

Json MethodEntry::identity(const std::string& world, std::uint64_t seed) const {
    if (kind_ == "filter") {
        return {{"kind", kind_}, {"filter", settings_.at("filter")}, {"model", model_fingerprint()}, {"seed", seed}};
    }
    if (kind_ == "external") {
        return {{"kind", kind_}, {"file", file_fingerprint(file(world, seed))}};
    }
    if (kind_ == "known-map") {
        return {{"kind", kind_}, {"odometry", settings_.at("odometry")}, {"seed", seed}};
    }
    return {{"kind", kind_}};
}

std::unique_ptr<Method> MethodEntry::start(const std::string& world, std::uint64_t seed) const {
    if (kind_ == "filter") {
        return std::make_unique<FilterMethod>(filter_settings(settings_, seed), detectors_);
    }
    if (kind_ == "external") {
        return std::make_unique<ExternalMethod>(file(world, seed));
    }
    if (kind_ == "known-map") {
        return std::make_unique<KnownMapMethod>(sim::odometry_preset(settings_.at("odometry")), seed);
    }
    return std::make_unique<OdometryMethod>();
}

std::string MethodEntry::model_fingerprint() const {
    return detectors_.model_fingerprint(parts_of(filter_settings(settings_, 0).method).detector);
}

std::string MethodEntry::file(const std::string& world, std::uint64_t seed) const {
    return expand(settings_.at("trajectories").get<std::string>(), world, seed);
}

}  // namespace ddtool::compare
