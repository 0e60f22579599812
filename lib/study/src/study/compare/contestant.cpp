#include "study/compare/contestant.hpp"

#include <algorithm>
#include <filesystem>

#include "base/overloaded.hpp"
#include "base/pattern.hpp"
#include "ddtool/base/error.hpp"
#include "ddtool/base/thread_pool.hpp"
#include "methods/settings_json.hpp"
#include "scores/tum_file.hpp"
#include "study/compare/known_map.hpp"
#include "system/fingerprint.hpp"

namespace ddtool::compare {
namespace {

class OdometryEstimator : public Estimator {
public:
    void process(const SensorFrame& frame) override {
        trajectory_.push_back({frame.scan.stamp_ns, frame.odom_from_robot});
    }
    Trajectory trajectory() override { return trajectory_; }

private:
    Trajectory trajectory_;
};

/// Runs ddtool's filter on one thread, because the comparison runs many cells at once.
class FilterEstimator : public Estimator {
public:
    FilterEstimator(const FilterSettings& settings, const DetectorTable& detectors)
        : filter_(make_filter(settings, detectors, threads_)) {}
    void process(const SensorFrame& frame) override { filter_->update(frame); }
    Trajectory trajectory() override { return filter_->trajectory(); }

private:
    ThreadPool threads_{1};
    std::unique_ptr<ParticleFilter> filter_;
};

/// The trajectory that another program computed from the same log.
class ExternalEstimator : public Estimator {
public:
    explicit ExternalEstimator(std::string file) : file_(std::move(file)) {}
    void process(const SensorFrame& /*frame*/) override {}
    Trajectory trajectory() override { return read_tum(file_); }

private:
    std::string file_;
};

constexpr const char* filter_kind = "filter";
constexpr const char* odometry_kind = "odometry";
constexpr const char* external_kind = "external";
constexpr const char* known_map_kind = "known-map";

/// The kind that an item names, or "filter" if it names none.
std::string kind_of(const Json& item) {
    const bool named = item.is_object() && item.contains("kind") && item.at("kind").is_string();
    return named ? item.at("kind").get<std::string>() : filter_kind;
}

/// The keys of an item of this kind, except name and kind, with their defaults.
Json defaults_of(const std::string& kind, const Json& filter, const std::string& where) {
    if (kind == filter_kind) {
        return {{"filter", filter}};
    }
    if (kind == odometry_kind) {
        return Json::object();
    }
    if (kind == external_kind) {
        return {{"trajectories", ""}, {"optional", false}};
    }
    if (kind == known_map_kind) {
        return {{"odometry", "typical"}};
    }
    throw UsageError(where + ": kind '" + kind + "': expected filter, odometry, external or known-map");
}

FilterSettings filter_settings(Json filter) {
    filter["seed"] = 0U;
    return filter_settings_from_json(filter);
}

}  // namespace

Contestant::Contestant(const Json& item, const Json& filter, const std::string& where, DetectorTable detectors)
    : detectors_(std::move(detectors)) {
    const std::string kind = kind_of(item);
    Json settings{{"name", ""}, {"kind", kind}};
    settings.update(defaults_of(kind, filter, where));
    merge_settings(settings, item, where);
    name_ = settings.at("name").get<std::string>();
    if (name_.empty()) {
        throw UsageError(where + ": expected a name");
    }
    kind_ = kind_from(settings, kind, where);
    if (const auto* own = std::get_if<Filter>(&kind_)) {
        ThreadPool one(1);
        // checks the settings now, so that a mistake is not found only when the first run starts
        (void)make_filter(own->settings, detectors_, one);
    }
}

Contestant::Kind Contestant::kind_from(const Json& settings, const std::string& kind, const std::string& where) {
    if (kind == filter_kind) {
        return Filter{filter_settings(settings.at("filter")), settings.at("filter")};
    }
    if (kind == known_map_kind) {
        const auto odometry = settings.at("odometry").get<std::string>();
        // throws now if the preset is unknown, and not only when the first run starts
        (void)sim::odometry_preset(odometry);
        return KnownMap{odometry};
    }
    if (kind == external_kind) {
        const auto trajectories = settings.at("trajectories").get<std::string>();
        if (trajectories.empty()) {
            throw UsageError(where + ": expected trajectories, the path of TUM files with {world} and {seed} in it");
        }
        return External{trajectories, settings.at("optional").get<bool>()};
    }
    return Odometry{};
}

bool Contestant::is_absent(const std::vector<std::string>& worlds, const std::vector<std::uint64_t>& seeds) const {
    const auto* external = std::get_if<External>(&kind_);
    return external != nullptr && external->optional && std::ranges::none_of(worlds, [&](const std::string& world) {
               return std::ranges::any_of(seeds, [&](std::uint64_t seed) {
                   return std::filesystem::exists(expand(external->trajectories, world, seed));
               });
           });
}

Json Contestant::identity(const std::string& world, std::uint64_t seed) const {
    return std::visit(overloaded{[&](const Filter& filter) -> Json {
                                     const std::string detector = parts_of(filter.settings.method).detector;
                                     return {{"kind", filter_kind},
                                             {"filter", without_other_filters(filter.json)},
                                             {"model", detectors_.model_fingerprint(detector)},
                                             {"seed", seed}};
                                 },
                                 [](const Odometry&) -> Json {
                                     return {{"kind", odometry_kind}};
                                 },
                                 [&](const External& external) -> Json {
                                     const std::string file = expand(external.trajectories, world, seed);
                                     return {{"kind", external_kind}, {"file", file_fingerprint(file)}};
                                 },
                                 [&](const KnownMap& known) -> Json {
                                     return {{"kind", known_map_kind}, {"odometry", known.odometry}, {"seed", seed}};
                                 }},
                      kind_);
}

std::unique_ptr<Estimator> Contestant::start(const std::string& world, std::uint64_t seed,
                                             std::shared_ptr<const ScanTruth> truth) const {
    using Started = std::unique_ptr<Estimator>;
    return std::visit(
        overloaded{[&](const Filter& filter) -> Started {
                       FilterSettings settings = filter.settings;
                       settings.rbpf.seed = seed;
                       DetectorTable detectors = detectors_;
                       detectors.know(truth);
                       return std::make_unique<FilterEstimator>(settings, detectors);
                   },
                   [](const Odometry&) -> Started { return std::make_unique<OdometryEstimator>(); },
                   [&](const External& external) -> Started {
                       return std::make_unique<ExternalEstimator>(expand(external.trajectories, world, seed));
                   },
                   [&](const KnownMap& known) -> Started {
                       return std::make_unique<KnownMapEstimator>(sim::odometry_preset(known.odometry), seed, truth);
                   }},
        kind_);
}

}  // namespace ddtool::compare
