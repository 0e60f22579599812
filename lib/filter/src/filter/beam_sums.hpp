#pragma once

#include <array>
#include <cstddef>

namespace ddtool {

/// The beams of one match, padded to whole vector lanes. Lengths are in cells; x and y are those of MatchPoints (robot
/// frame), the others those of Residuals (world frame).
struct BeamArrays {
    const float* x;
    const float* y;
    const float* residual_x;
    const float* residual_y;
    const float* normal_x;
    const float* normal_y;
    const float* along_weight;
    const float* found;
    const float* known;
};

/// The sums that make up the normal equations of Gauss-Newton: the upper triangle of the Hessian, the gradient, and the
/// score; and of the weights, alone and times q.
enum Sum : std::size_t { xx, xy, xt, yy, yt, tt, gx, gy, gt, total_score, total_weight, weighted_square, sum_count };
using Sums = std::array<double, sum_count>;

/// Sets `sums` to the sums over `beams` beams (a multiple of the lane count); c and s are the cosine and sine of the
/// robot's heading. Each beam has the weight (1 - q / reach^2)^2, from the derivative of its score (1 - q / reach^2)^3
/// (Tukey's biweight), where q is the squared distance across the surface plus along_weight times the squared distance
/// along it.
void add_normal_equations(const BeamArrays& b, std::size_t beams, float c, float s, float inverse_reach2, Sums& sums);

/// Sum of the scores of every stride-th block of beams, a block being one set of vector lanes.
double sum_of_scores(const BeamArrays& b, std::size_t beams, std::size_t stride, float inverse_reach2);

struct LogLikelihood {
    double sum = 0.0;
    double known_beams = 0.0;
};

/// Sets `result` to the sum of -min(q * inverse_two_sigma2, miss) over the beams that end in known ground, and to the
/// number of these beams.
void add_log_likelihoods(const BeamArrays& b, std::size_t beams, float inverse_two_sigma2, float miss,
                         LogLikelihood& result);

}  // namespace ddtool
