#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "dataset/manifest.hpp"
#include "ddtool/base/random.hpp"
#include "sim/simulation.hpp"

namespace ddtool::dataset {

/// The part of a drive that a run filters: all of it, or a piece of it if all would cost too much.
struct DriveWindow {
    std::size_t first_frame = 0;
    std::uint64_t most_updates = 0;      ///< the run ends after this many updates
    std::uint64_t expected_updates = 0;  ///< about this many updates will occur

    [[nodiscard]] double share_done(std::uint64_t updates) const {
        const auto expected = static_cast<double>(std::max<std::uint64_t>(1, expected_updates));
        return std::min(1.0, static_cast<double>(updates) / expected);
    }
};

/// The cost of a run is the number of particles times the number of updates. A drive that would cost more than
/// `most_particle_updates` is cut to a piece that begins at a random place.
DriveWindow window_of(const sim::Simulation& simulation, const RunEntry& run, std::uint64_t most_particle_updates,
                      RandomStream random);

}  // namespace ddtool::dataset
