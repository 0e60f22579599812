#include "run/run_page.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/text.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "ddtool/swarm/swarm_shape.hpp"
#include "run/run_explorer.hpp"
#include "scores/trajectory_score.hpp"
#include "swarm/weights.hpp"
#include "system/png_file.hpp"

namespace ddtool {
namespace {

std::vector<report::Fact> facts_of(const RunPageContent& content) {
    const RunSummary& run = content.summary;
    const RunCost& cost = content.cost;
    const auto length = [](double length_m, int decimals) { return fixed_text(length_m, decimals) + " m"; };
    std::vector<report::Fact> facts{
        {"scans", std::to_string(run.scans)},
        {"duration", fixed_text(run.duration_s, 1) + " s"},
        {"path", length(run.path_m, 1)},
        {"map", fixed_text(run.map_width_m, 1) + " x " + length(run.map_height_m, 1)},
        {"filter updates", std::to_string(run.updates)},
        {"resamplings", std::to_string(run.resamplings)},
        {"wall time", fixed_text(cost.wall_s, 1) + " s"},
        {"memory", fixed_text(1e-6 * static_cast<double>(cost.peak_memory_bytes), 0) + " MB"}};
    if (run.step) {
        facts.push_back({"step, 99 % below", fixed_text(run.step->p99_ms, 1) + " ms"});
    }
    facts.insert(facts.begin(), content.first_facts.begin(), content.first_facts.end());
    if (run.errors && run.errors->absolute) {
        facts.insert(facts.begin(), {"ATE (rmse)", length(run.errors->absolute->translation_m.rmse, 3)});
    }
    return facts;
}

/// The row of the explorer that is nearest in time to the stamp.
std::size_t row_at(std::int64_t stamp_ns, const RunCourse& course, const std::vector<std::size_t>& updates) {
    const auto apart_ns = [&](std::size_t update) { return std::abs(course.updates()[update].stamp_ns - stamp_ns); };
    const auto nearest = std::min_element(updates.begin(), updates.end(),
                                          [&](std::size_t a, std::size_t b) { return apart_ns(a) < apart_ns(b); });
    return static_cast<std::size_t>(nearest - updates.begin());
}

std::string caption_of(const WorstMoments::Moment& moment) {
    const std::vector<SnapshotParticle>& particles = moment.swarm.particles;
    const SwarmShape shape = swarm_shape(particles, &SnapshotParticle::pose);
    return "effective sample size " + fixed_text(effective_sample_size(weights_of(particles)), 1) + " of " +
           std::to_string(particles.size()) + ", spread " + fixed_text(shape.major_sd_m(), 3) + " x " +
           fixed_text(shape.minor_sd_m(), 3) + " m";
}

report::Moment shown(const WorstMoments::Moment& moment, ParticleRenderer& renderer, std::size_t row, double time_s) {
    ParticleImage image;
    renderer.render(moment.swarm.particles, image);
    const std::string png =
        png_bytes({.width_px = image.size_px, .height_px = image.size_px, .channels = 1, .pixels = image.pixels});
    return {{"degree " + fixed_text(moment.degree, 3) + " at " + fixed_text(time_s, 1) + " s", png, caption_of(moment)},
            row};
}

void add_worst_moments(report::Page& page, const RunCourse& course, const RunExplorer& explorer,
                       const ImageSettings& image) {
    page.section("Worst moments");
    const std::vector<WorstMoments::Moment> worst = course.worst().ranked();
    if (worst.empty()) {
        page.text("No degree above 0: the method has no detector, or it saw nothing degenerate.");
        return;
    }
    page.text("The highest degrees, a few seconds apart at least. The particles as a network sees them: the image \"" +
              Json(image.swarm).get<std::string>() + "\".");
    ParticleRenderer renderer(image);
    std::vector<report::Moment> moments;
    for (const WorstMoments::Moment& moment : worst) {
        const std::size_t row = row_at(moment.swarm.stamp_ns, course, explorer.updates);
        moments.push_back(shown(moment, renderer, row, explorer.data.at("x").at("values").at(row)));
    }
    page.moments(moments);
}

void add_loops(report::Page& page, const BackEndResults& back_end) {
    const graph::Smoothed& smoothed = back_end.smoothed;
    page.section("Loops")
        .text("The pose graph has " + std::to_string(smoothed.graph.poses.size()) + " nodes. " +
              (smoothed.map ? "The loops contradict the filter's path, so that path and map are those of the graph. "
                            : "The loops agree with the filter's path, so that path and map are the filter's. ") +
              "Pairs of places that might be the same were compared; " + "run.json lists each.")
        .table(loop_table(smoothed.loops));
}

Table stage_table(const RunSummary& run) {
    Table table({{"stage"}, {"wall time [s]"}});
    for (const auto& [name, seconds] : stages_of(run)) {
        table.add_row({name.substr(0, name.rfind("_s")), seconds});
    }
    return table;
}

}  // namespace

report::Page run_page(const RunPageContent& content) {
    const RunExplorer explorer = run_explorer(content.run, content.map, content.course);
    report::Page page(content.command, std::filesystem::path(content.log_file).filename().string());
    page.warnings(content.warnings).facts(facts_of(content));
    page.section("Map and time lines")
        .text(
            "Point at the path or at a line to see what was so there; click a line to bring its place into view. The "
            "marks at the bottom of the effective sample size are resamplings.")
        .explorer(explorer.data);
    if (content.back_end != nullptr) {
        add_loops(page, *content.back_end);
    }
    add_worst_moments(page, content.course, explorer, content.image);
    if (content.summary.errors) {
        page.section("Errors against the ground truth")
            .text("The path is aligned with the truth first (SE(2)).")
            .table(score_table(*content.summary.errors));
    }
    page.section("Where the time went").table(stage_table(content.summary));
    page.section("Settings and versions")
        .values("Settings", content.settings)
        .values("Log", content.log)
        .values("Versions", content.versions);
    return page;
}

}  // namespace ddtool
