#pragma once

#include <string>
#include <vector>

#include "command.hpp"
#include "dataset/dataset.hpp"

namespace ddtool {

/// Judges detectors on a data set.
class EvalCommand : public Command {
public:
    EvalCommand();

protected:
    void add_options(CLI::App& app) override;
    [[nodiscard]] Json default_settings() const override;
    ExitCode run(const Json& settings) override;

private:
    [[nodiscard]] ExitCode ablate(const Json& options) const;
    void print_label_noise(const dataset::Dataset& data) const;

    std::string data_;
    std::vector<std::string> models_;
    std::string fit_;
    std::string out_;
    std::string ablation_;
    bool label_noise_ = false;
    bool as_json_ = false;
};

}  // namespace ddtool
