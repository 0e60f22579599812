#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace ddtool {

/// The folder of the data set that commands make and take if the user names none.
inline constexpr const char* standard_dataset = "dataset";

/// Returns `folder`. If it was not named by the user, it is standard_dataset, which this tells on stderr; throws Error
/// saying how to make it if it is not there. Must be called after train::engine(), which may start the whole command
/// anew.
std::filesystem::path data_folder(const std::string& folder, bool named);

/// The newest network in the folder, by the time at which its file was written: a checkpoint FOLDER/NAME/best.pt, as
/// ddtool train writes it, or an exported model FOLDER/NAME.pt. Returns nullopt if there is none, also if the folder
/// cannot be read.
std::optional<std::filesystem::path> newest_model_in(const std::filesystem::path& folder);

}  // namespace ddtool
