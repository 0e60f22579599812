#include "build_dataset_command.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>

#include "dataset/assemble.hpp"
#include "dataset/build_settings.hpp"
#include "dataset/counts.hpp"
#include "dataset/image_files.hpp"
#include "dataset_report.hpp"
#include "system/log.hpp"
#include "system/progress.hpp"
#include "version.hpp"

namespace ddtool {
namespace {

using Clock = std::chrono::steady_clock;
using dataset::RunResult;

/// Whether all runs were made and nothing in their logs was skipped; says what was.
bool complete(const std::vector<RunResult>& results) {
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

}  // namespace

BuildDatasetCommand::BuildDatasetCommand()
    : Command("build-dataset", "Labelled particle snapshots from worlds, logs and recordings",
              "ddtool build-dataset --config configs/dataset/small.json --out out/small") {}

void BuildDatasetCommand::add_options(CLI::App& app) {
    app.add_option("--out", folder_, "Folder of the data set; runs that are finished there are not made again")
        ->type_name("DIR")
        ->required();
    app.add_option("--threads", threads_, "Runs at the same time; 0 is one a core")->capture_default_str();
    auto* shard = app.add_option("--shard", shard_, "Make only every n-th run, from the i-th, and no data set yet")
                      ->type_name("i/n");
    app.add_option("--merge", merged_, "Make no run: put together what --shard made in these folders and in --out")
        ->type_name("DIR")
        ->expected(1, -1)
        ->excludes(shard);
    app.add_flag("--images", with_images_,
                 "Write every sample as PNG, too, in folders by label, split, part and class");
    app.add_flag("--json", as_json_, "Print JSON instead of tables");
}

Json BuildDatasetCommand::default_settings() const { return dataset::default_build_json(); }

std::vector<RunResult> BuildDatasetCommand::runs_of(const dataset::RunPlan& plan) const {
    const dataset::WorkShare share = shard_.empty() ? dataset::WorkShare{} : dataset::parse_work_share(shard_);
    dataset::PartStore store(folder_, merged_);
    if (!merged_.empty()) {
        return dataset::find_parts(plan, store);
    }
    ThreadPool threads(threads_);
    return dataset::make_parts(plan, share, store, threads, program_version());
}

ExitCode BuildDatasetCommand::run(const Json& settings) {
    const Clock::time_point start = Clock::now();
    const auto elapsed = [&] { return format_duration(std::chrono::duration<double>(Clock::now() - start).count()); };
    (void)dataset::assembly_from_json(settings);  // a value that makes no sense shows now, not after all runs
    const dataset::RunPlan plan = dataset::plan_runs(settings);
    const std::vector<RunResult> results = runs_of(plan);
    if (!shard_.empty()) {
        log_info("shard " + shard_ + " made in " + elapsed());
        return complete(results) ? ExitCode::done : ExitCode::done_with_loss;
    }
    const dataset::Manifest manifest = dataset::assemble(folder_, settings, plan, results, program_version());
    for (const std::string& shortage : dataset::shortages_in(manifest.counts)) {
        log_warning(shortage);
    }
    const dataset::Dataset data(folder_);
    const auto image = settings.at("image").get<ImageSettings>();
    print_dataset(data, as_json_);
    const std::filesystem::path pictures = std::filesystem::path(folder_) / "pictures";
    draw_dataset(pictures, data, image);
    const bool has_page = write_dataset_page(folder_, pictures, data);
    if (with_images_) {
        ThreadPool threads(threads_);
        dataset::write_image_files(folder_, data, image, threads);
    }
    log_info("built in " + elapsed());
    return complete(results) && has_page ? ExitCode::done : ExitCode::done_with_loss;
}

}  // namespace ddtool
