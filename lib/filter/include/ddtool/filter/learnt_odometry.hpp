#pragma once

#include "ddtool/filter/odometry_model.hpp"

namespace ddtool {

/// What is assumed of an odometry before the scans have told anything, and how it is learnt. These are no settings:
/// they were settled on logs and worlds together, and the learnt values feed back into the poses that they are learnt
/// from, so that what helps in one place undoes another.
struct OdometryLearning {
    static constexpr double scale_sd = 0.02;           ///< of the relative error of distances, a constant of the run
    static constexpr double bias_sd_rad_per_s = 1e-3;  ///< of the error of the turn rate, a constant of the run
    static constexpr MotionNoise noise{0.03, 0.01, 0.01, 0.03};
    /// The assumed noise counts as if seen in so many chords: enough for the first chord not to decide alone.
    static constexpr double noise_chords = 3.0;
    static constexpr double remembered_chords = 300.0;  ///< older noise is forgotten: floors change
    /// Motions are judged over this way: on shorter ones the errors of single matches count, and ways of up to 20 m
    /// were not better.
    static constexpr double chord_m = 1.0;
    static constexpr double chord_turn_rad = 1.0;  ///< or this much turning
    /// A chord teaches where the scans held the robot this well all along.
    static constexpr double observed_sd_m = 0.03;
    static constexpr double observed_sd_rad = 0.005;
    /// Factor on the learnt standard deviations: they are learnt from poses that the odometry itself has pulled, so
    /// that its confidence feeds on itself.
    static constexpr double caution = 1.5;
};

/// Learns the odometry's scale, its gyro's bias and the size of its noise where the scans observe the motion, and uses
/// them where they do not. Residuals are those of chords, so that the error of a single match, which the next takes
/// back, counts little: r = s L + e along a straight chord of length L, r = b T + e for the turn in a time T. Scale and
/// bias are Kalman filters of one state; the variance of e grows with way and turn, and its factors are averages over
/// the chords (what a chord's square says is shared between way and turn as the present factors would).
class LearntOdometry : public OdometryModel {
public:
    LearntOdometry();

    [[nodiscard]] Pose2 expected(const Pose2& odometry_motion, double duration_s) const override;
    [[nodiscard]] MotionSigmas sigmas(const Pose2& odometry_motion, double duration_s) const override;
    void learn(const ObservedMotion& motion) override;

    /// True distance over the odometry's.
    [[nodiscard]] double scale() const { return 1.0 + scale_.mean; }
    [[nodiscard]] double scale_sd() const;
    /// To be added to the odometry's turn rate.
    [[nodiscard]] double bias_rad_per_s() const { return bias_.mean; }
    [[nodiscard]] MotionNoise noise() const;

private:
    struct Estimate {
        double mean = 0.0;
        double variance = 0.0;
        /// A measurement `value` of `gain` times the state, with a variance of its own.
        void correct(double value, double gain, double noise_variance);
    };
    /// A variance that grows with a measure of motion, averaged over chords.
    struct NoiseRate {
        double sum = 0.0;
        double chords = 0.0;
        [[nodiscard]] double rate() const { return sum / chords; }
        void add(double ratio, double share, double most_chords);
    };
    struct Chord {
        Pose2 odometry;
        Pose2 matched;  ///< along one particle's past: steps of different particles add up to a way that none went
        std::size_t updates = 0;
        double way_m = 0.0;
        double turn_rad = 0.0;
        double duration_s = 0.0;
        double along_sd_m = 0.0;  ///< the worst on the way
        double heading_sd_rad = 0.0;
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
