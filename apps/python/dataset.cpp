#include "dataset/dataset.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "dataset/labels.hpp"
#include "ddtool/base/error.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "ddtool/network/shipped_model.hpp"
#include "host.hpp"
#include "sources.hpp"
#include "swarm.hpp"

namespace ddtool::python {
namespace {

using dataset::Dataset;

/// The place of a name in a list. Throws UsageError that begins with `argument`.
template <std::size_t Count>
std::size_t place_of(const std::array<const char*, Count>& names, const std::string& name, const char* argument) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        throw UsageError(std::string(argument) + ": expected " +
                         joined(std::vector<std::string>(names.begin(), names.end())) + ", not '" + name + "'");
    }
    return static_cast<std::size_t>(found - names.begin());
}

std::size_t checked_index(const Dataset& data, py::ssize_t index) {
    const auto count = static_cast<py::ssize_t>(data.size());
    const py::ssize_t at = index < 0 ? index + count : index;
    if (at < 0 || at >= count) {
        throw py::index_error("the data set has " + std::to_string(count) + " samples");
    }
    return static_cast<std::size_t>(at);
}

/// The dtype of an .npy header, as NumPy reads it.
py::dtype dtype_of(const NpyFormat& format) {
    const py::object descr = py::module_::import("ast").attr("literal_eval")(format.descr);
    return py::reinterpret_steal<py::dtype>(py::module_::import("numpy").attr("dtype")(descr).release());
}

py::list sample_shards(const py::object& self) {
    const py::dtype dtype = dtype_of(dataset::samples_format());
    py::list arrays;
    for (const dataset::MappedShard& shard : self.cast<const Dataset&>().shards()) {
        const auto rows = shard.samples();
        arrays.append(sealed(py::array(dtype, {static_cast<py::ssize_t>(rows.size())}, {sizeof(dataset::SampleRecord)},
                                       rows.data(), self)));
    }
    return arrays;
}

py::list particle_shards(const py::object& self) {
    constexpr py::ssize_t columns = sizeof(SnapshotParticle) / sizeof(double);
    py::list arrays;
    for (const dataset::MappedShard& shard : self.cast<const Dataset&>().shards()) {
        const auto rows = shard.particles();
        const double* const first = rows.empty() ? nullptr : &rows.front().pose.x_m;
        arrays.append(view(first, {static_cast<py::ssize_t>(rows.size()), columns},
                           {sizeof(SnapshotParticle), sizeof(double)}, self));
    }
    return arrays;
}

py::array_t<std::int16_t> labels_of(const Dataset& data, const std::string& rule) {
    const auto label_rule = static_cast<dataset::LabelRule>(place_of(dataset::label_rule_names, rule, "rule"));
    py::array_t<std::int16_t> labels(static_cast<py::ssize_t>(data.size()));
    for (std::size_t index = 0; index < data.size(); ++index) {
        labels.mutable_data()[index] = static_cast<std::int16_t>(data.sample(index).label_of(label_rule));
    }
    return labels;
}

py::array_t<double> dispersion_of(const Dataset& data, const std::string& weight) {
    const std::size_t column = place_of(dataset::dispersion_weight_names, weight, "weight");
    py::array_t<double> values(static_cast<py::ssize_t>(data.size()));
    for (std::size_t index = 0; index < data.size(); ++index) {
        values.mutable_data()[index] = data.sample(index).dispersion[column];
    }
    return values;
}

py::array_t<std::int64_t> part_of(const Dataset& data, const std::string& part, const std::string& split,
                                  const std::string& rule) {
    const std::vector<std::size_t> indices =
        data.part(static_cast<dataset::LabelRule>(place_of(dataset::label_rule_names, rule, "rule")),
                  static_cast<dataset::Split>(place_of(dataset::split_names, split, "split")),
                  static_cast<dataset::Part>(place_of(dataset::part_names, part, "part")));
    py::array_t<std::int64_t> array(static_cast<py::ssize_t>(indices.size()));
    std::transform(indices.begin(), indices.end(), array.mutable_data(),
                   [](std::size_t index) { return static_cast<std::int64_t>(index); });
    return array;
}

HeldSwarm swarm_of(const std::shared_ptr<const Dataset>& data, py::ssize_t index) {
    const std::size_t at = checked_index(*data, index);
    const dataset::SampleRecord& sample = data->sample(at);
    return {data, data->particles(at), sample.stamp_ns, sample.update, sample.odometry_motion};
}

py::array_t<std::uint8_t> images_of(const Dataset& data, const std::vector<py::ssize_t>& indices,
                                    const std::string& detector, const std::optional<py::dict>& settings) {
    Json json = image_seen_natively(expect_model_file(detector));
    merge_dict(json, settings);
    ParticleRenderer renderer(json.get<ImageSettings>());
    std::vector<std::size_t> samples;
    samples.reserve(indices.size());
    for (const py::ssize_t index : indices) {
        samples.push_back(checked_index(data, index));
    }
    const std::size_t side = renderer.settings().size_px;
    py::array_t<std::uint8_t> images({samples.size(), side, side});
    std::uint8_t* const pixels = images.mutable_data();
    without_gil([&] {
        for (std::size_t image = 0; image < samples.size(); ++image) {
            renderer.render(data.particles(samples[image]), std::span(pixels + image * side * side, side * side));
            if (image % 1024 == 1023) {
                stop_if_asked();
            }
        }
    });
    return images;
}

py::list runs_of(const Dataset& data) {
    py::list runs;
    for (const dataset::RunEntry& run : data.manifest().runs) {
        py::dict entry;
        entry["id"] = run.id;
        entry["source"] = data.manifest().sources.at(run.source).name;
        entry["scene"] = run.scene;
        entry["seed"] = run.seed;
        entry["particles"] = run.particles;
        entry["lidar"] = run.lidar;
        entry["odometry"] = run.odometry;
        entry["method"] = run.method;
        runs.append(entry);
    }
    return runs;
}

}  // namespace

void add_datasets(py::module_& module) {
    py::class_<Dataset, std::shared_ptr<Dataset>>(module, "Dataset",
                                                  R"(A data set of `ddtool build-dataset`; open_dataset() makes it.

Its files are mapped into memory: opening reads no sample, and the arrays in shards and particles are read-only views of
the files. Sample i is row i of the shards one after the other. docs/formats/dataset.md explains the fields.)")
        .def("__len__", &Dataset::size)
        .def_property_readonly("shards", &sample_shards,
                               "A list of structured arrays, one per file, a sample per row: views of the files.")
        .def_property_readonly(
            "particles", &particle_shards,
            "A list of (P, 13) float64 arrays, one per file, a particle per row: views of the files. "
            "The rows of a sample begin at its first_particle.")
        .def_property_readonly("runs", &runs_of,
                               "A dict for each run that the samples come from; the field run of a sample counts them.")
        .def_property_readonly(
            "settings", [](const Dataset& data) { return json_to_python(data.manifest().settings); },
            "The settings that the data set was built with.")
        .def("labels", &labels_of, py::arg("rule") = "dispersion",
             R"((N,) int16: 1 degenerate, 0 not, -1 unknown. rule: "dispersion" or "fisher".)")
        .def(
            "dispersion", &dispersion_of, py::arg("weight") = "log_likelihood",
            R"((N,) The paper's R over a weight: "log_likelihood", "log_likelihood_increment", "match_score" or "weight".)")
        .def("part", &part_of, py::arg("part"), py::arg("split") = "held_out", py::arg("rule") = "dispersion",
             R"((M,) int64, the samples in a part of a split, in rising order.

part: "train", "validation", "test" or "unused". split: "held_out", by scenes, or "paper", at random.)")
        .def("swarm", &swarm_of, py::arg("index"), "The Swarm of a sample: a view of the file.")
        .def("images", &images_of, py::arg("indices"), py::kw_only(), py::arg("detector") = shipped_model_name,
             py::arg("settings") = py::none(), "(M, S, S) uint8, the images of these samples as render() draws them.")
        .def("__repr__",
             [](const Dataset& data) { return "<ddtool.Dataset of " + std::to_string(data.size()) + " samples>"; });
    module.def(
        "open_dataset",
        [](const py::object& folder, bool checksums) {
            const std::filesystem::path path = existing_path(folder);
            return without_gil([&] {
                return std::make_shared<Dataset>(path, checksums ? dataset::Check::checksums : dataset::Check::sizes);
            });
        },
        py::arg("folder"), py::kw_only(), py::arg("checksums") = false,
        "Opens a data set of `ddtool build-dataset`. checksums: read every byte once to find damage.");
}

}  // namespace ddtool::python
