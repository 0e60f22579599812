// map_a_log LOG: prints the pose and the degree of degeneracy while the filter reads a log of any kind, and then the
// extent of the map.
#include <exception>
#include <iostream>
#include <stdexcept>

#include "ddtool/methods/driven_scans.hpp"
#include "ddtool/methods/method.hpp"

int main(int argc, char** argv) try {
    if (argc != 2) {
        throw std::runtime_error("expected: map_a_log LOG");
    }
    ddtool::ThreadPool threads;
    const ddtool::FilterSettings settings;
    const auto filter = ddtool::make_filter(settings, {}, threads);
    const auto report = [](const ddtool::LogProblem& problem) { std::cerr << problem.what << '\n'; };
    ddtool::DrivenScans scans(ddtool::open_log(argv[1], {}, report), settings.rbpf);
    while (const auto frame = scans.next()) {
        if (const auto update = filter->update(*frame)) {
            std::cout << update->pose.x_m << ' ' << update->pose.y_m << ' ' << update->degeneracy.degree << '\n';
        }
    }
    const ddtool::CellBox box = filter->map().observed_box();
    std::cout << "map of " << box.x_max - box.x_min << " x " << box.y_max - box.y_min << " cells\n";
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
