#pragma once

#include "ddtool/filter/odometry_model.hpp"

namespace ddtool {

/// What is assumed about an odometry before any scan has been seen, and how it is learnt. These values are not
/// settings. They were chosen on logs and simulated worlds together; since the learnt values influence the poses that
/// they are learnt from, tuning them for one place makes others worse.
struct OdometryLearning {
    static constexpr double scale_sd = 0.02;           ///< of the relative error of distances, constant in a run
    static constexpr double bias_sd_rad_per_s = 1e-3;  ///< of the error of the turn rate, constant in a run
    static constexpr MotionNoise noise{0.03, 0.01, 0.01, 0.03};
    /// The assumed noise has the weight of this many chords, so that the first chord does not decide alone.
    static constexpr double noise_chords = 3.0;
    static constexpr double remembered_chords = 300.0;  ///< older noise is gradually forgotten, since floors change
    /// A chord ends after this distance. On shorter ones the errors of single matches matter too much; lengths of up to
    /// 20 m gave no better results.
    static constexpr double chord_m = 1.0;
    static constexpr double chord_turn_rad = 1.0;  ///< a chord also ends after this much turning
    /// A chord is used only if, at every update of it, the scans determined the pose at least this well.
    static constexpr double observed_sd_m = 0.03;
    static constexpr double observed_sd_rad = 0.005;
    /// Factor on the standard deviations that are reported. The odometry has influenced the poses that it is learnt
    /// from, so the learnt deviations alone would be too small.
    static constexpr double caution = 1.5;
};

/// Learns the odometry's scale, its gyro's bias and the size of its noise where the scans determine the motion, and
/// uses them where the scans do not. The residuals are those of chords (the motion over several updates), so that the
/// error of a single match, which the next match undoes, has little effect: r = s L + e along a straight chord of
/// length L, and r = b T + e for the turn in a time T. Scale s and bias b are each estimated by a Kalman filter of one
/// state. The variance of the noise e grows with the distance and the turn; its two factors are averages over the
/// chords. The squared residual of a chord is divided between distance and turn in the proportion that the present
/// factors predict.
class LearntOdometry : public OdometryModel {
public:
    LearntOdometry();
    /// Goes on with what was learnt before.
    explicit LearntOdometry(const OdometryState& state);

    [[nodiscard]] Pose2 expected(const Pose2& odometry_motion, double duration_s) const override;
    [[nodiscard]] MotionSigmas sigmas(const Pose2& odometry_motion, double duration_s) const override;
    void learn(const ObservedMotion& motion) override;
    [[nodiscard]] std::optional<OdometryState> state() const override;

    /// True distance divided by the odometry's distance.
    [[nodiscard]] double scale() const { return 1.0 + scale_.mean; }
    [[nodiscard]] double scale_sd() const;
    /// Value to add to the odometry's turn rate.
    [[nodiscard]] double bias_rad_per_s() const { return bias_.mean; }
    [[nodiscard]] MotionNoise noise() const;

private:
    struct Estimate {
        double mean = 0.0;
        double variance = 0.0;
        /// Takes in a measurement whose expected value is `gain` times the state and whose noise has `noise_variance`.
        void correct(double value, double gain, double noise_variance);
    };
    /// A variance per unit of motion (metre or radian), averaged over chords.
    struct NoiseRate {
        double sum = 0.0;
        double chords = 0.0;
        [[nodiscard]] double rate() const { return sum / chords; }
        void add(double ratio, double share, double most_chords);
    };
    struct Chord {
        Pose2 odometry;
        Pose2 matched;  ///< motion along the past of one particle
        std::size_t updates = 0;
        double way_m = 0.0;
        double turn_rad = 0.0;
        double duration_s = 0.0;
        double along_sd_m = 0.0;      ///< largest of all updates of the chord
        double heading_sd_rad = 0.0;  ///< largest of all updates of the chord
    };

    void learn_scale();
    void learn_turn();
    [[nodiscard]] double along_variance(double way_m, double turn_rad) const;
    [[nodiscard]] double turn_variance(double way_m, double turn_rad) const;

    Estimate scale_;
    Estimate bias_;
    NoiseRate along_per_m_, along_per_rad_, turn_per_m_, turn_per_rad_;
    Chord chord_;
};

}  // namespace ddtool
