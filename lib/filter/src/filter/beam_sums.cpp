#include "filter/beam_sums.hpp"

#include "base/lanes.hpp"

namespace ddtool {
namespace {

/// For eight beams: the surface normals, the distances across and along the surface, and q =
/// across^2 + along_weight * along^2. Lengths are in cells.
struct Distance {
    Lanes nx, ny, across, along, q;
};

inline __attribute__((always_inline)) void measure(const BeamArrays& b, std::size_t i, Distance& d) {
    Lanes ex;
    Lanes ey;
    Lanes along_weight;
    load(d.nx, b.normal_x + i);
    load(d.ny, b.normal_y + i);
    load(ex, b.residual_x + i);
    load(ey, b.residual_y + i);
    load(along_weight, b.along_weight + i);
    d.across = d.nx * ex + d.ny * ey;
    d.along = d.nx * ey - d.ny * ex;
    d.q = d.across * d.across + along_weight * d.along * d.along;
}

/// max(0, 1 - q / reach^2); 0 for beams that end far from any occupied point.
inline __attribute__((always_inline)) void closeness(const BeamArrays& b, std::size_t i, const Lanes& q,
                                                     float inverse_reach2, Lanes& result) {
    Lanes found;
    load(found, b.found + i);
    const Lanes zero{};
    const Lanes raw = 1.0F - q * inverse_reach2;
    result = (raw > zero ? raw : zero) * found;
}

}  // namespace

DDTOOL_VECTORISED void add_normal_equations(const BeamArrays& b, std::size_t beams, float c, float s,
                                            float inverse_reach2, Sums& sums) {
    std::array<Lanes, sum_count> total{};
    for (std::size_t i = 0; i < beams; i += lane_count) {
        Distance d;
        Lanes x;
        Lanes y;
        Lanes near_by;
        Lanes along_weight;
        measure(b, i, d);
        closeness(b, i, d.q, inverse_reach2, near_by);
        load(x, b.x + i);
        load(y, b.y + i);
        load(along_weight, b.along_weight + i);
        const Lanes weight = near_by * near_by;
        const Lanes lever_x = -(s * x + c * y);  // the derivative of the end point with respect to theta
        const Lanes lever_y = c * x - s * y;
        const Lanes across_t = d.nx * lever_x + d.ny * lever_y;
        const Lanes along_t = d.nx * lever_y - d.ny * lever_x;
        const Lanes w_along = weight * along_weight;
        total[xx] += weight * d.nx * d.nx + w_along * d.ny * d.ny;
        total[xy] += weight * d.nx * d.ny - w_along * d.nx * d.ny;
        total[yy] += weight * d.ny * d.ny + w_along * d.nx * d.nx;
        total[xt] += weight * d.nx * across_t - w_along * d.ny * along_t;
        total[yt] += weight * d.ny * across_t + w_along * d.nx * along_t;
        total[tt] += weight * across_t * across_t + w_along * along_t * along_t;
        total[gx] += weight * d.nx * d.across - w_along * d.ny * d.along;
        total[gy] += weight * d.ny * d.across + w_along * d.nx * d.along;
        total[gt] += weight * across_t * d.across + w_along * along_t * d.along;
        total[total_score] += near_by * weight;
        total[total_weight] += weight;
        total[weighted_square] += weight * d.q;
    }
    for (std::size_t k = 0; k < sum_count; ++k) {
        sums[k] = sum_of(total[k]);
    }
}

DDTOOL_VECTORISED double sum_of_scores(const BeamArrays& b, std::size_t beams, std::size_t stride,
                                       float inverse_reach2) {
    Lanes total{};
    for (std::size_t i = 0; i < beams; i += stride * lane_count) {
        Distance d;
        Lanes near_by;
        measure(b, i, d);
        closeness(b, i, d.q, inverse_reach2, near_by);
        total += near_by * near_by * near_by;
    }
    return sum_of(total);
}

DDTOOL_VECTORISED void add_log_likelihoods(const BeamArrays& b, std::size_t beams, float inverse_two_sigma2, float miss,
                                           LogLikelihood& result) {
    Lanes total{};
    Lanes known_beams{};
    for (std::size_t i = 0; i < beams; i += lane_count) {
        Distance d;
        Lanes found;
        Lanes known;
        measure(b, i, d);
        load(found, b.found + i);
        load(known, b.known + i);
        const Lanes most = Lanes{} + miss;
        const Lanes scaled = d.q * inverse_two_sigma2 * found + most * (1.0F - found);
        total -= (scaled < most ? scaled : most) * known;
        known_beams += known;
    }
    result = {sum_of(total), sum_of(known_beams)};
}

}  // namespace ddtool
