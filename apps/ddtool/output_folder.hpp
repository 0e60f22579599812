#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace ddtool {

/// The folder that a command writes its results to: the one of --out or, if the user has named none, a new one in the
/// current folder. The new folder is called NAME or, if that exists, NAME-2, NAME-3, ..., so that nothing that exists
/// is overwritten.
class OutputFolder {
public:
    /// Returns whether a folder holds work that was stopped before its end, on which the same command can go on.
    using Unfinished = std::function<bool(const std::filesystem::path& folder)>;

    /// \param given the value of --out; empty if the user has named no folder. A folder that is given is not created.
    /// \param name the name of a new folder, which is created at once, so that no other program can take the name
    /// \param unfinished if set, the first of the folders NAME, NAME-2, ... for which it returns true is used again
    /// Tells on stderr which folder was chosen. Throws OutputError if a new folder cannot be created. Must be called
    /// after train::engine(), which may start the whole command anew.
    OutputFolder(const std::string& given, const std::string& name, const Unfinished& unfinished = {});
    /// Removes a new folder that is still empty, so that a command that fails at its beginning leaves nothing behind.
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    bool created_ = false;
};

/// The name of a folder for the results of a log: "run" for "logs/run.mcap", "run.bag", "run.clf.gz", the folder "run/"
/// and its "run/metadata.yaml"; "slam" if the log is standard input ("-") or has no name of its own, such as "..".
std::string name_of_results(const std::string& log);

}  // namespace ddtool
