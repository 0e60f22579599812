#include "man_command.hpp"

#include <filesystem>
#include <iostream>

#include "man_page.hpp"
#include "system/atomic_file.hpp"
#include "system/folder.hpp"

namespace ddtool {
namespace {

const CLI::App& page_owner(const CLI::App& program, const std::string& command) {
    if (command.empty()) {
        return program;
    }
    const auto found = program.get_subcommands([&](const CLI::App* each) { return each->get_name() == command; });
    if (found.empty()) {
        throw UsageError("man '" + command + "': expected a command; ddtool --help lists them");
    }
    return *found.front();
}

void write_page(const CLI::App& app, const std::filesystem::path& folder) {
    write_file(folder / (man_page_name(app) + ".1"), man_page(app));
}

}  // namespace

void ManCommand::add_options(CLI::App& app) {
    program_ = app.get_parent();
    app.add_option("COMMAND", command_, "Whose page to print; ddtool's own where not given");
    app.add_option("--out", folder_, "Instead: write every page there")->type_name("DIR");
}

ExitCode ManCommand::run(const Json& /*settings*/) {
    if (folder_.empty()) {
        std::cout << man_page(page_owner(*program_, command_));
        return ExitCode::done;
    }
    const std::filesystem::path folder = made_folder(folder_);
    write_page(*program_, folder);
    for (const CLI::App* command : program_->get_subcommands([](const CLI::App*) { return true; })) {
        write_page(*command, folder);
    }
    return ExitCode::done;
}

}  // namespace ddtool
