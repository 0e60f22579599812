#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "ddtool/system/settings.hpp"
#include "py.hpp"

namespace ddtool::python {

/// Registers ddtool.Error, UsageError and OutputError, and turns the library's exceptions into them.
void add_errors(py::module_& module);

/// From now on the library's log messages go to Python's logger "ddtool".
void log_to_python();

/// Runs work that touches no Python object, while other Python threads go on.
template <typename Work>
auto without_gil(Work&& work) {
    const py::gil_scoped_release release;
    return std::forward<Work>(work)();
}

/// Throws what Python's signal handlers throw, such as KeyboardInterrupt. Takes the GIL, so it may be called without.
void stop_if_asked();

/// The path of a str or os.PathLike. Throws FileNotFoundError if nothing is there.
std::filesystem::path existing_path(const py::object& path);

/// The name of a detector as it is. Throws FileNotFoundError if it is that of a network's file that is not there.
const std::string& expect_model_file(const std::string& detector);

/// JSON from dict, list, tuple, str, bool, None and numbers, NumPy's too. Throws TypeError for anything else.
Json json_from(const py::handle& value);
/// dict, list, str, bool, None, int and float from JSON.
py::object json_to_python(const Json& json);

/// Puts a dict of settings into `settings`, by the names of the JSON: nested ({"filter": {"seed": 3}}), or with dots as
/// --set has them ({"filter.seed": 3}). Throws UsageError as merge_settings() does.
void merge_dict(Json& settings, const std::optional<py::dict>& changes);

}  // namespace ddtool::python
