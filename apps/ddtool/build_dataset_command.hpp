#pragma once

#include "command.hpp"
#include "dataset/parts.hpp"

namespace ddtool {

/// Makes particle snapshots from worlds, logs and recordings, labels them and writes a data set.
class BuildDatasetCommand : public Command {
public:
    BuildDatasetCommand();

protected:
    void add_options(CLI::App& app) override;
    [[nodiscard]] Json default_settings() const override;
    ExitCode run(const Json& settings) override;

private:
    [[nodiscard]] std::vector<dataset::RunResult> runs_of(const dataset::RunPlan& plan) const;

    std::string folder_;
    std::string shard_;
    std::vector<std::string> merged_;
    std::size_t threads_ = 0;
    bool with_images_ = false;
    bool as_json_ = false;
};

}  // namespace ddtool
