#include "localization/localizer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ddtool/base/error.hpp"
#include "ddtool/filter/scan_noise.hpp"
#include "swarm/modes.hpp"
#include "swarm/weights.hpp"

namespace ddtool::localization {
namespace {

/// Keys of random streams, apart from those of the filter.
constexpr std::uint64_t start_draw = 101;

/// The probability that a robot is not where it was said to be at the start, and that it is at none of the places that
/// a search of the whole map found.
constexpr double lost_at_given_start = 0.1;
constexpr double lost_after_search = 0.5;
/// A search is worth its time where this much speaks against the present places.
constexpr double doubtful = 0.3;
/// The way between two searches; it grows until the robot is found.
constexpr double first_interval_m = 0.3;
constexpr double most_interval_m = 3.0;
/// Particles that begin at the places of the first search, all together, and at a given start.
constexpr std::size_t first_particles = 90;
/// A place that was found is known already if a particle of some weight is as near as this.
constexpr double known_m = 0.4;
constexpr double known_rad = 0.2;
constexpr double known_weight = 1e-3;
/// A scan of fewer points, as on open ground, counts less, and one of none not at all.
constexpr double whole_scan_points = 40.0;
/// So sure of its place for so long, a robot may map on.
constexpr double sure_to_map = 0.95;
constexpr double sure_way_m = 1.0;

FilterStrategies with_modes(FilterStrategies strategies, const ModeResamplingSettings& particles) {
    strategies.resampling = std::make_shared<ModeResampling>(particles);
    return strategies;
}

}  // namespace

Localizer::Localizer(const RbpfSettings& settings, const ModeResamplingSettings& particles, ThreadPool& threads,
                     FilterStrategies strategies, std::shared_ptr<const OccupancyGrid> map,
                     std::optional<StartPose> start, MapUse use)
    : settings_(settings),
      particles_(particles),
      map_(std::move(map)),
      start_(start),
      use_(use),
      filter_(settings, threads, with_modes(std::move(strategies), particles), map_),
      search_(*map_, settings.matcher),
      watch_(start ? lost_at_given_start : lost_after_search),
      search_every_m_(first_interval_m) {
    if (map_->observed_box().empty()) {
        throw Error("the map is empty: nothing in it was observed");
    }
    if (start) {
        trust_.told();
    }
}

void Localizer::expect_at(const StartPose& place) {
    start_ = place;
    started_ = false;
    complete_ = true;
    sure_m_ = 0.0;
    since_search_m_ = 0.0;
    search_every_m_ = first_interval_m;
    watch_.restart(lost_at_given_start);
    trust_.told();
}

std::optional<Update> Localizer::update(const SensorFrame& frame) {
    if (!started_) {
        started_ = true;
        filter_.place(at_start(scan_points(frame, settings_.points)), 0.0);
    }
    std::optional<Update> update = filter_.update(frame);
    if (!update || is_mapping_) {
        return update;
    }
    const ScanPoints& points = filter_.points();
    const double way_m = way_for_scans_m(update->corrected.odometry_motion);
    const std::vector<Mode> modes = modes_of(update->corrected.particles);
    standing_ = {.mode_weight = modes.front().weight,  // that of the pose
                 .modes = modes.size(),
                 .particles = update->corrected.particles.size(),
                 .support = scan_fit(points, *map_, update->pose).support()};
    watch_.add(standing_.support, way_m * std::min(1.0, static_cast<double>(points.size()) / whole_scan_points));
    since_search_m_ += way_m;
    standing_.lost = watch_.probability();
    if (standing_.lost < doubtful) {
        search_every_m_ = first_interval_m;
    }
    if (search_is_due()) {
        standing_.searched = true;
        since_search_m_ = 0.0;
        const std::vector<Hypothesis> found =
            found_places(points, update->corrected.particles, std::min(standing_.lost, 1.0 - 1e-6));
        search_every_m_ = std::min(1.5 * search_every_m_, most_interval_m);
        if (!found.empty()) {
            filter_.place(found, 1.0 - std::min(standing_.lost, 1.0 - 1e-6));
        }
    }
    // Where a search could not follow up every place, the right one may not be among them.
    standing_.probability = (1.0 - standing_.lost) * standing_.mode_weight * (complete_ ? 1.0 : 0.5);
    trust_.add(standing_.probability, standing_.lost);
    standing_.place = trust_.state();
    sure_m_ = standing_.probability >= sure_to_map ? sure_m_ + way_m : 0.0;
    if (use_ == MapUse::going_on && sure_m_ >= sure_way_m) {
        filter_.map_on();
        is_mapping_ = true;
    }
    return update;
}

bool Localizer::search_is_due() const { return standing_.lost > doubtful && since_search_m_ >= search_every_m_; }

std::vector<Hypothesis> Localizer::at_start(const ScanPoints& points) {
    if (start_) {
        return about(*start_);
    }
    std::vector<Hypothesis> places = found_places(points, {}, 1.0);
    if (places.empty()) {
        // The scan fits nowhere: anywhere in the map, until a search finds a place.
        const CellBox box = map_->observed_box();
        const double cell_m = map_->cell_size_m();
        Hypothesis anywhere{.pose = {0.5 * cell_m * (box.x_min + box.x_max), 0.5 * cell_m * (box.y_min + box.y_max)}};
        anywhere.covariance.diagonal() << std::pow(0.3 * cell_m * (box.x_max - box.x_min), 2),
            std::pow(0.3 * cell_m * (box.y_max - box.y_min), 2), 3.0;
        places.push_back(anywhere);
    }
    std::vector<Hypothesis> all;
    const std::size_t each = std::max<std::size_t>(1, first_particles / places.size());
    for (Hypothesis& place : places) {
        place.log_weight = 0.0;  // the first update weighs them by this scan
        all.insert(all.end(), each, place);
    }
    return all;
}

std::vector<Hypothesis> Localizer::about(const StartPose& start) const {
    std::vector<Hypothesis> all;
    // The draws span the start's deviation, and each covers the space between itself and the next.
    const double share = std::pow(static_cast<double>(first_particles), -1.0 / 3.0);
    Hypothesis each;
    each.covariance.diagonal() << std::pow(share * start.sd_m, 2), std::pow(share * start.sd_m, 2),
        std::pow(share * start.sd_rad, 2);
    each.log_weight = -std::log(static_cast<double>(first_particles));
    for (std::size_t index = 0; index < first_particles; ++index) {
        RandomStream random({settings_.seed, start_draw, index});
        const double x = index == 0 ? 0.0 : random.normal();
        const double y = index == 0 ? 0.0 : random.normal();
        const double turn = index == 0 ? 0.0 : random.normal();
        each.pose = {start.pose.x_m + start.sd_m * x, start.pose.y_m + start.sd_m * y,
                     wrap_angle(start.pose.theta_rad + start.sd_rad * turn)};
        all.push_back(each);
    }
    return all;
}

/// The places where the scan fits and no particle is yet, with weights that sum to `weight`.
std::vector<Hypothesis> Localizer::found_places(const ScanPoints& points, std::span<const SnapshotParticle> known,
                                                double weight) {
    FoundPlaces found = search_.search(points);
    complete_ = found.complete;
    std::erase_if(found.places, [&](const FoundPlace& place) {
        return std::ranges::any_of(known, [&](const SnapshotParticle& particle) {
            return particle.weight > known_weight && distance_m(particle.pose, place.pose) < known_m &&
                   std::abs(wrap_angle(particle.pose.theta_rad - place.pose.theta_rad)) < known_rad;
        });
    });
    std::vector<double> log_weights;
    for (const FoundPlace& place : found.places) {
        log_weights.push_back(settings_.likelihood_gain * place.log_likelihood);
    }
    const std::vector<double> shares = normalised_weights(log_weights);
    std::vector<Hypothesis> places;
    for (std::size_t index = 0; index < found.places.size(); ++index) {
        if (shares[index] > 0.0 && places.size() < particles_.most_particles) {
            places.push_back({.pose = found.places[index].pose,
                              .covariance = found.places[index].covariance,
                              .log_weight = std::log(weight * shares[index])});
        }
    }
    return places;
}

}  // namespace ddtool::localization
