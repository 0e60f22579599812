#include "methods/settings_json.hpp"

#include <string>
#include <utility>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

/// Slightly more than pi, so that pi itself is allowed.
constexpr double half_turn_rad = 3.15;
constexpr const char* gmapping_name = "gmapping";
constexpr const char* failed_match_name = "failed_match";
constexpr const char* grisetti = "Grisetti et al. 2007";

const SettingTable<MotionNoise>& motion_rows() {
    // The noise must not be zero, because the information of the odometry would then be infinite.
    const Allowed noise = Allowed::number(1e-4, 10.0);
    const std::string source = "the defaults are GMapping's at its step of 1 m and 1 rad";
    static const SettingTable<MotionNoise> rows{
        {"translation_per_translation", &MotionNoise::translation_per_translation, noise, "m/sqrt(m)",
         "Noise of the way that grows with the way.", source},
        {"translation_per_rotation", &MotionNoise::translation_per_rotation, noise, "m/sqrt(rad)",
         "Noise of the way that grows with turning.", source},
        {"rotation_per_translation", &MotionNoise::rotation_per_translation, noise, "rad/sqrt(m)",
         "Noise of the heading that grows with the way.", source},
        {"rotation_per_rotation", &MotionNoise::rotation_per_rotation, noise, "rad/sqrt(rad)",
         "Noise of the heading that grows with turning.", source},
    };
    return rows;
}

const SettingTable<OccupancySettings>& grid_rows() {
    using Grid = OccupancySettings;
    static const SettingTable<Grid> rows{
        {"cell_size_m", &Grid::cell_size_m, Allowed::number(0.005, 1.0), "m",
         "Side of a cell of the map; the memory grows with its inverse square.", "everything was measured at 0.05"},
        {"hit_step", &Grid::hit_step, Allowed::whole(1, 27), "",
         "Evidence for \"occupied\" that a beam ending in a cell adds, in steps of log odds.",
         "a cell is occupied when the share free_step / (hit_step + free_step) of its observations are hits"},
        {"free_step", &Grid::free_step, Allowed::whole(1, 27), "",
         "Evidence for \"free\" that a beam passing through a cell adds, in steps of log odds.", "see hit_step"},
        {"min_log_odds", &Grid::min_log_odds, Allowed::whole(-100, -1), "",
         "A cell is never more certainly free than this, in steps of log odds.", "8-bit cells"},
        {"max_log_odds", &Grid::max_log_odds, Allowed::whole(1, 100), "",
         "A cell is never more certainly occupied than this, in steps of log odds.", "8-bit cells"},
        {"most_memory_mib", &Grid::most_memory_mib, Allowed::whole(0, 1e9), "MiB",
         "The run ends with what it has when all maps together would take more; 0 stands for three quarters of the "
         "memory that the machine has free."},
    };
    return rows;
}

const SettingTable<ScanPointsSettings>& points_rows() {
    using Points = ScanPointsSettings;
    static const SettingTable<Points> rows{
        {"usable_range_m", &Points::usable_range_m, Allowed::number(0.1, 800.0), "m",
         "Longer ranges are left out: their end points are far from each other, and some drivers report them where "
         "nothing was met."},
        {"spacing_m", &Points::spacing_m, Allowed::number(0.0, 10.0), "m",
         "Neighbouring end points that are nearer than this are merged into one."},
        {"deskew", &Points::deskew, Allowed::flag(), "",
         "Whether each beam is placed where the laser was when the beam was measured, by the odometry's motion during "
         "the scan.",
         "docs/filter.md"},
    };
    return rows;
}

const SettingTable<ScanMatcherSettings>& matcher_rows() {
    using Matcher = ScanMatcherSettings;
    static const SettingTable<Matcher> rows{
        {"reach_m", &Matcher::reach_m, Allowed::number(0.005, 10.0), "m",
         "A beam that ends farther than this from any occupied point says nothing about the pose.", "Tukey's biweight"},
        {"max_iterations", &Matcher::max_iterations, Allowed::whole(1, 1000), "",
         "A match ends after so many Gauss-Newton steps, converged or not."},
        {"beam_sigma_m", &Matcher::beam_sigma_m, Allowed::number(1e-3, 10.0), "m",
         "Standard deviation of the distance from an end point to the mapped surface.",
         "likelihood field, Thrun et al. 2005, 6.4"},
        {"doubtful_score", &Matcher::doubtful_score, Allowed::number(0.0, 1.0), "",
         "A match with a lower mean score per beam is tried again from a wide search."},
        {"search_turn_rad", &Matcher::search_turn_rad, Allowed::number(0.0, half_turn_rad), "rad",
         "The wide search tries turns of up to this size, to each side."},
        {"search_distance_m", &Matcher::search_distance_m, Allowed::number(0.0, 10.0), "m",
         "The wide search tries shifts of up to this size, to each side."},
    };
    return rows;
}

const SettingTable<RbpfSettings>& rbpf_rows() {
    using Rbpf = RbpfSettings;
    static const SettingTable<Rbpf> rows{
        {"particles", &Rbpf::particles, Allowed::whole(1, 10000), "",
         "Number of hypotheses, each with its own map; time and memory grow with it.", grisetti},
        {"seed", &Rbpf::seed, Allowed::seed(), "",
         "Everything that is drawn by chance follows from it: the same seed gives the same result."},
        {"update_distance_m", &Rbpf::update_distance_m, Allowed::number(1e-3, 100.0), "m",
         "The filter updates when the odometry has moved this far since the last update.", grisetti},
        {"update_turn_rad", &Rbpf::update_turn_rad, Allowed::number(1e-3, 100.0), "rad",
         "The filter updates, too, when the odometry has turned this much.", grisetti},
        {"resample_share", &Rbpf::resample_share, Allowed::number(0.0, 1.0), "",
         "The filter resamples when the effective sample size falls below this share of the particles.",
         "Doucet et al. 2000; Grisetti et al. 2007, eq. 20"},
        {"likelihood_gain", &Rbpf::likelihood_gain, Allowed::number(0.0, 10.0), "",
         "Exponent on the likelihood of a scan: neighbouring beams and scans err together, so that their product is "
         "too sure."},
        {"full_weight_sd_m", &Rbpf::full_weight_sd_m, Allowed::number(0.0, 10.0), "m",
         "likelihood_gain holds for scans that usually lie this close to the map (standard deviation); scans of "
         "noisier "
         "lidars weigh less, by the square of the ratio. 0: all weigh alike."},
        {"insert_distance_m", &Rbpf::insert_distance_m, Allowed::number(0.0, 100.0), "m",
         "A scan enters the map when the odometry has moved this far since the last one that did."},
        {"insert_turn_rad", &Rbpf::insert_turn_rad, Allowed::number(0.0, 100.0), "rad",
         "A scan enters the map, too, when the odometry has turned this much."},
        {"motion", &Rbpf::motion, motion_rows()},
        {"grid", &Rbpf::grid, grid_rows()},
        {"points", &Rbpf::points, points_rows()},
        {"matcher", &Rbpf::matcher, matcher_rows()},
    };
    return rows;
}

const SettingTable<LinearMotionNoise>& linear_motion_rows() {
    const Allowed noise = Allowed::number(0.0, 10.0);
    static const SettingTable<LinearMotionNoise> rows{
        {"translation_per_translation", &LinearMotionNoise::translation_per_translation, noise, "m/m",
         "Noise of the way that grows with the way.", "slam_gmapping's srr"},
        {"translation_per_rotation", &LinearMotionNoise::translation_per_rotation, noise, "m/rad",
         "Noise of the way that grows with turning.", "slam_gmapping's str"},
        {"rotation_per_translation", &LinearMotionNoise::rotation_per_translation, noise, "rad/m",
         "Noise of the heading that grows with the way.", "slam_gmapping's srt"},
        {"rotation_per_rotation", &LinearMotionNoise::rotation_per_rotation, noise, "rad/rad",
         "Noise of the heading that grows with turning.", "slam_gmapping's stt"},
    };
    return rows;
}

const SettingTable<HillClimbSettings>& hill_climb_rows() {
    using Climb = HillClimbSettings;
    static const SettingTable<Climb> rows{
        {"step_m", &Climb::step_m, Allowed::number(1e-4, 10.0), "m", "The search begins with steps of this length.",
         "slam_gmapping's lstep"},
        {"turn_rad", &Climb::turn_rad, Allowed::number(1e-4, half_turn_rad), "rad",
         "The search begins with turns of this size.", "slam_gmapping's astep"},
        {"halvings", &Climb::halvings, Allowed::whole(0, 20), "", "Steps and turns are halved so many times.",
         "slam_gmapping's iterations"},
        {"score_width_m2", &Climb::score_width_m2, Allowed::number(1e-6, 100.0), "m^2",
         "A beam that ends the distance d from the map scores exp(-d^2 / this).", "slam_gmapping's sigma"},
        {"likelihood_width_m2", &Climb::likelihood_width_m2, Allowed::number(1e-6, 100.0), "m^2",
         "The log-likelihood of such a beam is -d^2 / this; one that ends where the map has no hits counts as if d^2 "
         "were 0.5 m^2.",
         "slam_gmapping's lsigma"},
    };
    return rows;
}

const SettingTable<GmappingSettings>& gmapping_rows() {
    using Gmapping = GmappingSettings;
    static const SettingTable<Gmapping> rows{
        {"update_distance_m", &Gmapping::update_distance_m, Allowed::number(1e-3, 100.0), "m",
         "The filter of GMapping updates when the odometry has moved this far since the last update.",
         "slam_gmapping's linearUpdate"},
        {"update_turn_rad", &Gmapping::update_turn_rad, Allowed::number(1e-3, 100.0), "rad",
         "It updates, too, when the odometry has turned this much.", "slam_gmapping's angularUpdate"},
        {"resample_share", &Gmapping::resample_share, Allowed::number(0.0, 1.0), "",
         "It resamples when the effective sample size falls below this share of the particles.",
         "slam_gmapping's resampleThreshold"},
        {"likelihood_smoothing", &Gmapping::likelihood_smoothing, Allowed::number(1e-3, 1e6), "",
         "The weights are the likelihoods to the power of one over this and over the number of particles.",
         "slam_gmapping's ogain"},
        {"least_score", &Gmapping::least_score, Allowed::number(0.0, 1e6), "",
         "A match whose score, the sum over its beams, is not above this is dropped for the predicted pose.",
         "slam_gmapping's minimumScore"},
        {"usable_range_m", &Gmapping::usable_range_m, Allowed::number(0.0, 800.0), "m",
         "Longer ranges are left out; 0 stands for the lidar's own range.", "slam_gmapping's maxUrange"},
        {"motion", &Gmapping::motion, linear_motion_rows()},
        {"matcher", &Gmapping::matcher, hill_climb_rows()},
    };
    return rows;
}

/// The values of a setting that names a part: one of the names, or an empty text for the part that the method has.
Allowed part_of(std::vector<std::string> names) {
    names.insert(names.begin(), "");
    return Allowed::one_of(std::move(names));
}

const SettingTable<MethodParts>& parts_rows() {
    using Parts = MethodParts;
    static const SettingTable<Parts> rows{
        {"detector", &Parts::detector, Allowed::text(), "",
         "What tells the degree of degeneracy: a name, or the file of a network; empty for the method's own."},
        {"gate", &Parts::gate, part_of(gate_names()), "",
         "When the detector is asked: in-doubt, where matching is in doubt, or none, at every update; empty for the "
         "one "
         "that goes with the detector."},
        {"search", &Parts::search, part_of(search_names()), "",
         "A second search for the match; empty for the method's own."},
        {"trust", &Parts::trust, part_of(trust_names()), "",
         "How match and odometry are weighed; empty for the method's own."},
        {"resampling", &Parts::resampling, part_of(resampling_names()), "",
         "How the next generation of particles is drawn; empty for the method's own."},
        {"odometry", &Parts::odometry, part_of(odometry_names()), "",
         "What is taken for the motion: the odometry as logged, or with its learnt errors taken off; empty for the "
         "method's own."},
    };
    return rows;
}

const SettingTable<DetectionSettings>& detection_rows() {
    using Detection = DetectionSettings;
    static const SettingTable<Detection> rows{
        {"covariance_sd_m", &Detection::covariance_sd_m, Allowed::number(1e-4, 100.0), "m",
         "The detector covariance answers 0.5 where the swarm's larger standard deviation is this.",
         "Lee et al. 2024, Switch-SLAM"},
        {"doubt_share", &Detection::doubt_share, Allowed::number(0.0, 10.0), "",
         "The detector is asked where the match left this share of the predicted spread or more; 0 asks always."},
        {"every_m", &Detection::every_m, Allowed::number(0.0, 1000.0), "m",
         "The robot drives this far before the detector is asked again."},
    };
    return rows;
}

const SettingTable<CoarseFineSettings>& coarse_fine_rows() {
    using Search = CoarseFineSettings;
    const std::string source = "the paper, fig. system_pipeline";
    static const SettingTable<Search> rows{
        {"step_m", &Search::step_m, Allowed::number(1e-4, 10.0), "m",
         "The coarse search of coarse-fine steps this far, in eight directions.", source},
        {"turn_rad", &Search::turn_rad, Allowed::number(1e-4, half_turn_rad), "rad",
         "The coarse search of coarse-fine turns this much, to each side.", source},
    };
    return rows;
}

const SettingTable<CorrelativeSearchSettings>& correlative_rows() {
    using Search = CorrelativeSearchSettings;
    const std::string source = "Olson 2009";
    static const SettingTable<Search> rows{
        {"window_m", &Search::window_m, Allowed::number(1e-4, 10.0), "m",
         "The lattice of correlative reaches this far from the odometry's pose.", source},
        {"window_rad", &Search::window_rad, Allowed::number(1e-4, half_turn_rad), "rad",
         "The lattice of correlative turns this far from the odometry's heading.", source},
        {"steps", &Search::steps, Allowed::whole(1, 20), "",
         "The lattice has so many steps to each side in every direction; time grows with its cube.", source},
        {"levels", &Search::levels, Allowed::whole(1, 10), "",
         "The lattice is refined so many times; the window of each level is one step of the level before.", source},
        {"degenerate_share", &Search::degenerate_share, Allowed::number(0.0, 1.0), "",
         "The weak direction is not searched where the smaller eigenvalue of the normals' scatter is at most this "
         "share of the larger."},
    };
    return rows;
}

const SettingTable<FusionSettings>& fusion_rows() {
    using Fusion = FusionSettings;
    static const SettingTable<Fusion> rows{
        {"least_degree", &Fusion::least_degree, Allowed::number(0.0, 1.0), "",
         "The trust information leaves a match as it is where the degree is lower; 0: it weighs every match."},
        {"most_deviations", &Fusion::most_deviations, Allowed::number(0.1, 1000.0), "",
         "Odometry that is farther from the match than this many standard deviations of both counts as less sure."},
        {"settled_m", &Fusion::settled_m, Allowed::number(0.0, 1.0), "m",
         "The scan is judged anew where the fusion moved the pose by more."},
        {"settled_rad", &Fusion::settled_rad, Allowed::number(0.0, 1.0), "rad",
         "The scan is judged anew where the fusion turned the pose by more."},
    };
    return rows;
}

const SettingTable<EigenvalueGateSettings>& eigenvalue_gate_rows() {
    static const SettingTable<EigenvalueGateSettings> rows{
        {"least_share", &EigenvalueGateSettings::least_share, Allowed::number(0.0, 1.0), "",
         "The trust eigenvalue-gate takes the odometry's pose where the smaller eigenvalue of the match's information "
         "about the position is below this share of the larger.",
         "Zhang, Kaess, Singh 2016"},
    };
    return rows;
}

const SettingTable<EnhancedResamplingSettings>& enhanced_resampling_rows() {
    using Resampling = EnhancedResamplingSettings;
    const std::string source = "the paper, eq. random_perturbation";
    static const SettingTable<Resampling> rows{
        {"drop_below", &Resampling::drop_below, Allowed::number(0.0, 10.0), "",
         "The resampling enhanced drops particles of a lower weight; the mean weight is one.", source},
        {"perturbation_m", &Resampling::perturbation_m, Allowed::number(0.0, 10.0), "m",
         "Standard deviation of the noise that moves a particle of the mean weight.", source},
        {"least_weight", &Resampling::least_weight, Allowed::number(1e-3, 1.0), "",
         "A lower weight counts as this one for the noise.", source},
        {"most_weight", &Resampling::most_weight, Allowed::number(1.0, 1e6), "",
         "A higher weight counts as this one for the noise.", source},
    };
    return rows;
}

const SettingTable<FailedMatchSettings>& failed_match_rows() {
    static const SettingTable<FailedMatchSettings> rows{
        {"least_score", &FailedMatchSettings::least_score, Allowed::number(0.0, 10.0), "",
         "In the filter of GMapping, coarse-fine and lidar-score act where the match's score per beam, times phi(c), "
         "is "
         "not above this.",
         "the paper, eq. pose_es; GMapping's minimumScore"},
    };
    return rows;
}

/// The names of the parts are on the same level of the JSON as the settings of the filter. The settings of the parts
/// are groups that follow them.
const SettingTable<FilterSettings>& filter_rows() {
    using Method = MethodSettings;
    static const SettingTable<Method> names{
        {"method", &Method::method, Allowed::one_of(method_names()), "",
         "What the filter does about degeneracy (docs/anti-degeneracy.md)."},
        {&Method::parts, parts_rows()},
    };
    static const SettingTable<Method> parts{
        {"detection", &Method::detection, detection_rows()},
        {"coarse_fine", &Method::coarse_fine, coarse_fine_rows()},
        {"correlative", &Method::correlative, correlative_rows()},
        {"fusion", &Method::fusion, fusion_rows()},
        {"eigenvalue_gate", &Method::eigenvalue_gate, eigenvalue_gate_rows()},
        {"enhanced_resampling", &Method::enhanced_resampling, enhanced_resampling_rows()},
        {failed_match_name, &Method::failed_match, failed_match_rows()},
    };
    static const SettingTable<FilterSettings> rows{
        {&FilterSettings::method, names},
        {&FilterSettings::rbpf, rbpf_rows()},
        {gmapping_name, &FilterSettings::gmapping, gmapping_rows()},
        {&FilterSettings::method, parts},
    };
    return rows;
}

/// The scan matcher counts cells from the robot, and its floor_of() works for at most this many in each direction.
void expect_in_reach(const RbpfSettings& settings) {
    constexpr double most_cells_away = 16384.0;
    if (settings.points.usable_range_m > most_cells_away * settings.grid.cell_size_m) {
        throw UsageError("filter.points.usable_range_m: expected at most 16384 cells of filter.grid.cell_size_m");
    }
}

}  // namespace

const std::vector<Setting>& filter_setting_list() { return filter_rows().settings(); }

Json filter_settings_json(const FilterSettings& settings) { return filter_rows().json(settings); }

Json parts_json(const MethodSettings& settings) { return parts_rows().json(parts_of(settings)); }

Json common_filter_json() {
    Json json = filter_settings_json({});
    json.erase("seed");
    return json;
}

Json without_other_filters(Json filter) {
    const auto is_used = [&](const char* part) { return filter.at(part) != "" && filter.at(part) != "none"; };
    const auto method = filter.at("method").get<std::string>();
    if (!runs_gmapping(method)) {
        filter.erase(gmapping_name);
    }
    if (!runs_gmapping(method) || (method == gmapping_name && !is_used("search") && !is_used("trust"))) {
        filter.erase(failed_match_name);
    }
    return filter;
}

FilterSettings filter_settings_from_json(const Json& json) {
    FilterSettings settings = filter_rows().checked(json, "filter");
    expect_in_reach(settings.rbpf);
    return settings;
}

}  // namespace ddtool
