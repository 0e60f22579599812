#pragma once

#include "ddtool/filter/filter_run.hpp"
#include "ddtool/filter/rbpf.hpp"
#include "sim/simulated_stream.hpp"

namespace ddtool::test {

/// A drive of half a minute through a room with a pillar, with a coarse lidar.
class SmallRun {
public:
    SmallRun() : filter_(settings(), threads_), stream_(world(), simulation()) {}

    Rbpf& filter() { return filter_; }
    FilterRun run(const FrameObserver& observe) { return run_filter(stream_, filter_, observe); }

    static RbpfSettings settings() {
        RbpfSettings settings;
        settings.particles = 3;
        return settings;
    }

private:
    static sim::World world() {
        sim::World world;
        sim::add_box(world, {}, 6.0, 4.0);
        sim::add_box(world, {0.5, 1.0, 0.3}, 0.5, 0.4);
        world.route.start = {-2.0, -1.0, 0.0};
        world.route.way_points = {{2.0, -1.0}, {2.0, 1.0}};
        return world;
    }
    static sim::SimulationSettings simulation() {
        sim::SimulationSettings settings;
        settings.robot_from_laser = {0.1, 0.0, 0.2};
        settings.lidar.beams = 90;
        return settings;
    }

    ThreadPool threads_{1};
    Rbpf filter_;
    sim::SimulatedStream stream_;
};

}  // namespace ddtool::test
