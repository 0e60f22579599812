#include "study/judge/evaluation_page.hpp"

#include <array>

#include "study/judge/tables.hpp"

namespace ddtool::judge {
namespace {

struct PictureFile {
    const char* file;
    const char* title;
    const char* caption;
};

constexpr std::array<PictureFile, 4> figures{{
    {"confusion.png", "Decisions", "downwards what was so, rightwards what was decided"},
    {"reliability.png", "Reliability", "what degrees said against what was so"},
    {"roc.png", "ROC", "of the models and the best rules"},
    {"particles.png", "Accuracy by number of particles", ""},
}};
constexpr PictureFile mistakes{"mistakes.png", "Worst mistakes",
                               "as the detector sees them: left what it missed, right its false alarms"};

report::Picture read(const std::filesystem::path& folder, const PictureFile& about) {
    report::Picture picture = report::picture_of_file(about.title, folder / about.file);
    picture.caption = about.caption;
    return picture;
}

void add_pictures(report::Page& page, const std::filesystem::path& folder) {
    std::vector<report::Picture> pictures;
    for (const PictureFile& about : figures) {
        pictures.push_back(read(folder, about));
    }
    page.section("Curves and decisions").pictures(pictures);
    page.section("Worst mistakes").pictures(std::array{read(folder, mistakes)});
}

}  // namespace

void add_evaluations(report::Page& page, const std::filesystem::path& folder, const dataset::Dataset& data,
                     std::span<const Evaluation> evaluations, const Task& task) {
    for (const NamedTable& table : evaluation_tables(data, evaluations, task)) {
        page.section(table.name).table(table.table);
    }
    if (!evaluations.front().samples.indices.empty()) {
        add_pictures(page, folder);
    }
}

}  // namespace ddtool::judge
