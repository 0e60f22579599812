#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "ddtool/swarm/particle_snapshot.hpp"
#include "py.hpp"

namespace ddtool::python {

/// A swarm as Python sees it: particles of an update, of a data set that is mapped into memory, or of its own. `keeper`
/// is what the particles are part of.
struct HeldSwarm {
    std::shared_ptr<const void> keeper;
    std::span<const SnapshotParticle> particles;
    std::int64_t stamp_ns = 0;
    std::uint64_t update = 0;
    Pose2 odometry_motion;

    HeldSwarm(std::shared_ptr<const void> owner, std::span<const SnapshotParticle> rows, std::int64_t stamp,
              std::uint64_t number, const Pose2& motion)
        : keeper(std::move(owner)), particles(rows), stamp_ns(stamp), update(number), odometry_motion(motion) {}
    explicit HeldSwarm(const std::shared_ptr<const ParticleSnapshot>& swarm)
        : HeldSwarm(swarm, swarm->particles, swarm->stamp_ns, swarm->update, swarm->odometry_motion) {}

    /// A copy, as the library's detectors take it.
    [[nodiscard]] ParticleSnapshot snapshot() const {
        return {stamp_ns, update, odometry_motion, {particles.begin(), particles.end()}};
    }
};

/// Registers ddtool.Swarm, ddtool.Detector, and the functions about them.
void add_swarms(py::module_& module);

}  // namespace ddtool::python
