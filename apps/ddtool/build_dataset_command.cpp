#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>

#include "assumed_inputs.hpp"
#include "builtin_plans.hpp"
#include "commands.hpp"
#include "dataset/assemble.hpp"
#include "dataset/build_settings.hpp"
#include "dataset/counts.hpp"
#include "dataset/image_files.hpp"
#include "dataset/manifest.hpp"
#include "dataset_report.hpp"
#include "output_folder.hpp"
#include "system/folder.hpp"
#include "system/log.hpp"
#include "system/progress.hpp"
#include "version.hpp"

namespace ddtool {
namespace {

using Clock = std::chrono::steady_clock;
using dataset::RunResult;

struct BuildRequest {
    std::string folder;
    std::string shard;
    std::vector<std::string> merged;
    std::size_t threads = 0;
    bool with_images = false;
    bool as_json = false;
};

/// Returns whether all runs were made and nothing in their logs was skipped. Otherwise it prints what is missing.
bool all_runs_made(const std::vector<RunResult>& results) {
    const auto failed =
        std::count_if(results.begin(), results.end(), [](const RunResult& result) { return !result.failure.empty(); });
    const auto damaged = std::count_if(results.begin(), results.end(), [](const RunResult& result) {
        return result.value && result.value->log_problems > 0;
    });
    const auto foreign = std::count_if(results.begin(), results.end(), [](const RunResult& result) {
        return result.value && result.value->program != program_version();
    });
    const auto warn = [&](std::ptrdiff_t count, const std::string& what) {
        if (count > 0) {
            log_warning(std::to_string(count) + " of " + std::to_string(results.size()) + " runs " + what);
        }
    };
    warn(failed, "failed; the data set is without them");
    warn(damaged, "used a log of which something was skipped");
    warn(foreign, "were made by another build; without --out's folder parts they would be made anew");
    return failed == 0 && damaged == 0;
}

/// Whether a build in the folder was stopped. The same settings make the same runs, which are not made again; other
/// settings only make other runs beside them.
bool is_unfinished_build(const std::filesystem::path& folder) {
    return is_folder(folder / "parts") && !std::filesystem::exists(folder / dataset::manifest_name);
}

bool lacks_sources(const Json& settings) {
    return settings.at("worlds").empty() && settings.at("logs").empty() && settings.at("snapshots").empty();
}

std::vector<RunResult> runs_of(const BuildRequest& request, const dataset::RunPlan& plan,
                               const std::filesystem::path& folder) {
    const dataset::WorkShare share =
        request.shard.empty() ? dataset::WorkShare{} : dataset::parse_work_share(request.shard);
    dataset::PartStore store(folder, request.merged);
    if (!request.merged.empty()) {
        return dataset::find_parts(plan, store);
    }
    ThreadPool threads(request.threads);
    return dataset::make_parts(plan, share, store, threads, program_version());
}

ExitCode build_dataset(const BuildRequest& request, const Json& settings) {
    const Clock::time_point start = Clock::now();
    const auto elapsed = [&] { return format_duration(std::chrono::duration<double>(Clock::now() - start).count()); };
    // Checks the settings now, so that a mistake is not found only after all runs have been made.
    (void)dataset::assembly_from_json(settings);
    const dataset::RunPlan plan = dataset::plan_runs(settings);
    const OutputFolder output(request.folder, standard_dataset, is_unfinished_build);
    const std::filesystem::path& folder = output.path();
    const std::vector<RunResult> results = runs_of(request, plan, folder);
    if (!request.shard.empty()) {
        log_info("shard " + request.shard + " made in " + elapsed());
        return all_runs_made(results) ? ExitCode::done : ExitCode::done_with_loss;
    }
    const dataset::Manifest manifest = dataset::assemble(folder, settings, plan, results, program_version());
    for (const std::string& shortage : dataset::shortages_in(manifest.counts)) {
        log_warning(shortage);
    }
    const dataset::Dataset data(folder);
    const auto image = settings.at("image").get<ImageSettings>();
    print_dataset(data, request.as_json);
    const std::filesystem::path pictures = folder / "pictures";
    draw_dataset(pictures, data, image);
    const bool has_page = write_dataset_page(folder, pictures, data);
    if (request.with_images) {
        ThreadPool threads(request.threads);
        dataset::write_image_files(folder, data, image, threads);
    }
    log_info("built in " + elapsed());
    log_info("next: ddtool train" + (folder == standard_dataset ? "" : " --data " + folder.string()));
    return all_runs_made(results) && has_page ? ExitCode::done : ExitCode::done_with_loss;
}

}  // namespace

Command build_dataset_command() {
    const auto request = std::make_shared<BuildRequest>();
    return {
        .name = "build-dataset",
        .summary = "Labelled particle snapshots from worlds, logs and recordings",
        .example = "ddtool build-dataset --config configs/dataset/small.json --out out/small",
        .settings = dataset::default_build_json(),
        .plan = BuiltinPlan{default_dataset_name, default_dataset_plan(), lacks_sources},
        .options =
            {
                {"--out", &request->folder,
                 "Folder of the data set, where finished runs are not made again; if not given, the new one 'dataset'",
                 "DIR"},
                {"--threads", &request->threads, "Runs at the same time; 0 is one a core"},
                {"--shard", &request->shard, "Make only every n-th run, from the i-th, and no data set yet", "i/n"},
                {.name = "--merge",
                 .value = &request->merged,
                 .help = "Make no run: put together what --shard made in these folders and in --out",
                 .type = "DIR",
                 .excludes = "--shard"},
                {"--images", &request->with_images,
                 "Write every sample as PNG, too, in folders by label, split, part and class"},
                {"--json", &request->as_json, "Print JSON instead of tables"},
            },
        .run = [request](const Json& settings) { return build_dataset(*request, settings); }};
}

}  // namespace ddtool
