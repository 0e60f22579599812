#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "ddtool/system/settings.hpp"
#include "report/table.hpp"

namespace ddtool::report {

struct Fact {
    std::string name;
    std::string value;
};

struct Picture {
    std::string title;    ///< what the picture shows; also its text for people who cannot see it
    std::string png;      ///< the file's bytes
    std::string caption;  ///< may be empty
};

/// A picture that belongs to one row of the page's explorer.
struct Moment {
    Picture picture;
    std::size_t row = 0;
};

/// The last part of a folder's path, for a title; works for "." and "out/", too.
std::string folder_name(const std::filesystem::path& folder);

/// A picture from a PNG file. Throws Error naming the file if it cannot be read.
Picture picture_of_file(const std::string& title, const std::filesystem::path& file);

/// A report: one HTML file that needs no other file and no network, and is readable in light and dark colours, on wide
/// and narrow screens (docs/reports.md). All texts are escaped, so that they may contain any characters. Functions that
/// add a part return the page, so that calls can be chained.
class Page {
public:
    /// The most bytes that pictures take of a page, as PNG. Further pictures are named on the page, but left out.
    static constexpr std::size_t most_picture_bytes = 24'000'000;

    /// \param kind the command that made the page, such as "ddtool slam"
    Page(std::string kind, std::string title);

    /// Begins a section: what is added next stands under this heading.
    Page& section(const std::string& heading);
    /// Adds a paragraph; does nothing if the text is empty.
    Page& text(const std::string& words);
    /// Adds what readers should know before they trust the rest; does nothing if there are no lines.
    Page& warnings(std::span<const std::string> lines);
    /// Adds the main figures.
    Page& facts(std::span<const Fact> facts);
    /// Adds a table; does nothing if it has no rows.
    Page& table(const Table& table);
    Page& pictures(std::span<const Picture> pictures);
    /// Adds small pictures side by side, each with a button that leads to its row of the explorer.
    Page& moments(std::span<const Moment> moments);
    /// Adds settings, versions and the like in a folded section, with one row per value, named by its path in the JSON.
    Page& values(const std::string& title, const Json& values);
    /// Adds an interactive map and time lines (docs/reports.md). A page can have only one.
    Page& explorer(const Json& data);

    [[nodiscard]] std::string html() const;
    /// Writes the page under a temporary name and renames it. Throws OutputError naming the file.
    void write(const std::filesystem::path& file) const;

private:
    void figure(const Picture& picture, const std::string& button = "");
    [[nodiscard]] std::string navigation() const;

    std::string kind_;
    std::string title_;
    std::vector<std::string> headings_;
    std::string body_;
    std::size_t picture_bytes_ = 0;
    bool has_explorer_ = false;
};

/// Makes a page and writes it. Since results are worth more than a report of them, any failure is only a warning, and
/// the page of an earlier run is then removed. Returns whether the page was written.
bool write_page(const std::filesystem::path& file, const std::function<Page()>& make);

}  // namespace ddtool::report
