#include "host.hpp"

#include <exception>
#include <sstream>
#include <vector>

#include "ddtool/base/error.hpp"
#include "system/atomic_file.hpp"
#include "system/failure_text.hpp"
#include "system/log.hpp"

namespace ddtool::python {
namespace {

/// Never destroyed, because exceptions may be thrown until the interpreter ends.
struct ErrorTypes {
    PyObject* error = nullptr;
    PyObject* usage = nullptr;
    PyObject* output = nullptr;
};
ErrorTypes& error_types() {
    static ErrorTypes types;
    return types;
}

PyObject* new_error(py::module_& module, const char* name, const char* doc, const py::object& bases) {
    PyObject* const type =
        PyErr_NewExceptionWithDoc((std::string("ddtool.") + name).c_str(), doc, bases.ptr(), nullptr);
    if (type == nullptr) {
        throw py::error_already_set();
    }
    module.attr(name) = py::handle(type);
    return type;
}

void translate(std::exception_ptr thrown) {
    try {
        std::rethrow_exception(std::move(thrown));
    } catch (const OutputError& error) {
        PyErr_SetString(error_types().output, error.what());
    } catch (const UsageError& error) {
        PyErr_SetString(error_types().usage, error.what());
    } catch (const Error& error) {
        PyErr_SetString(error_types().error, error.what());
    } catch (const Json::exception& error) {
        PyErr_SetString(error_types().usage, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        PyErr_SetString(error_types().output, failure_text(error).c_str());
    }
}

int python_level(LogLevel level) { return 10 * (static_cast<int>(level) + 1); }  // logging.DEBUG is 10, INFO 20, ...

void write_to_python(LogLevel level, const std::string& line) {
    if (Py_IsInitialized() == 0) {
        return;
    }
    const py::gil_scoped_acquire gil;
    try {
        py::module_::import("logging").attr("getLogger")("ddtool").attr("log")(python_level(level), "%s", line);
    } catch (py::error_already_set& error) {
        error.discard_as_unraisable("ddtool: a log message");
    }
}

Json number_from(const py::handle& value) {
    if (PyLong_Check(value.ptr()) != 0) {
        int overflow = 0;
        const long long whole = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
        if (overflow == 0) {
            return whole < 0 ? Json(whole) : Json(static_cast<unsigned long long>(whole));
        }
        const unsigned long long seed = PyLong_AsUnsignedLongLong(value.ptr());  // beyond 2^63
        if (PyErr_Occurred() == nullptr) {
            return seed;
        }
        PyErr_Clear();
    }
    return value.cast<double>();
}

/// {"a.b": 1} as {"a": {"b": 1}}.
void put(Json& json, const std::string& path, Json value) {
    Json* at = &json;
    std::istringstream stream(path);
    for (std::string key; std::getline(stream, key, '.');) {
        at = &(*at)[key];
    }
    if (at->is_object() && value.is_object()) {
        at->update(value, true);
    } else {
        *at = std::move(value);
    }
}

}  // namespace

void add_errors(py::module_& module) {
    const auto exception = py::reinterpret_borrow<py::object>(PyExc_Exception);
    ErrorTypes& types = error_types();
    types.error =
        new_error(module, "Error",
                  "What ddtool could not do. The text is one line: what, where, and what was expected.", exception);
    const auto error = py::reinterpret_borrow<py::object>(types.error);
    types.usage = new_error(module, "UsageError", "A wrong argument or setting; also a ValueError.",
                            py::make_tuple(error, py::reinterpret_borrow<py::object>(PyExc_ValueError)));
    types.output = new_error(module, "OutputError", "A file that could not be written; also an OSError.",
                             py::make_tuple(error, py::reinterpret_borrow<py::object>(PyExc_OSError)));
    py::register_exception_translator(translate);
}

void log_to_python() { send_log_to(write_to_python); }

void stop_if_asked() {
    const py::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0) {
        throw py::error_already_set();
    }
}

std::filesystem::path existing_path(const py::object& path) {
    const py::object text = py::module_::import("os").attr("fspath")(path);
    std::filesystem::path found = py::isinstance<py::bytes>(text)
                                      ? text.cast<std::string>()
                                      : py::module_::import("os").attr("fsencode")(text).cast<std::string>();
    std::error_code failure;
    if (!std::filesystem::exists(found, failure)) {
        errno = failure ? failure.value() : ENOENT;
        PyErr_SetFromErrnoWithFilenameObject(PyExc_OSError, text.ptr());
        throw py::error_already_set();
    }
    return found;
}

const std::string& expect_model_file(const std::string& detector) {
    if (detector.ends_with(".safetensors")) {
        static_cast<void>(existing_path(py::str(detector)));
    }
    return detector;
}

Json json_from(const py::handle& value) {
    if (value.is_none()) {
        return {};
    }
    if (PyBool_Check(value.ptr()) != 0) {
        return value.cast<bool>();
    }
    if (PyLong_Check(value.ptr()) != 0 || PyFloat_Check(value.ptr()) != 0) {
        return number_from(value);
    }
    if (py::isinstance<py::str>(value)) {
        return value.cast<std::string>();
    }
    if (py::isinstance<py::dict>(value)) {
        Json json = Json::object();
        for (const auto& [key, item] : py::reinterpret_borrow<py::dict>(value)) {
            if (!py::isinstance<py::str>(key)) {
                throw py::type_error("settings: expected a str as key, not " + py::repr(key).cast<std::string>());
            }
            put(json, key.cast<std::string>(), json_from(item));
        }
        return json;
    }
    if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
        Json json = Json::array();
        for (const py::handle item : value) {
            json.push_back(json_from(item));
        }
        return json;
    }
    if (py::hasattr(value, "tolist")) {  // NumPy's numbers and arrays
        return json_from(value.attr("tolist")());
    }
    if (py::hasattr(value, "__fspath__")) {
        return value.attr("__fspath__")().cast<std::string>();
    }
    throw py::type_error("settings: expected numbers, text, lists and dicts, not " +
                         py::repr(value).cast<std::string>());
}

py::object json_to_python(const Json& json) { return py::module_::import("json").attr("loads")(json.dump()); }

void merge_dict(Json& settings, const std::optional<py::dict>& changes) {
    if (changes) {
        merge_settings(settings, json_from(*changes), "settings");
    }
}

}  // namespace ddtool::python
