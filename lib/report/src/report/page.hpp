#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "ddtool/system/settings.hpp"
#include "report/table.hpp"

namespace ddtool::html {

struct Fact {
    std::string name;
    std::string value;
};

struct Picture {
    std::string title;    ///< what it shows, also for those who cannot see it
    std::string png;      ///< the file's bytes
    std::string caption;  ///< may be empty
};

/// A picture of one row of the page's explorer.
struct Moment {
    Picture picture;
    std::size_t row = 0;
};

/// The last part of a folder's path, for a title; also of "." and "out/".
std::string name_of(const std::filesystem::path& folder);

/// A PNG file that lies about. Throws Error naming the file.
Picture picture_of_file(const std::string& title, const std::filesystem::path& file);

/// A report: one HTML file that needs no other and no network, readable in light and dark, on wide and narrow screens
/// (docs/reports.md). All texts are taken as text, whatever characters they have.
class Page {
public:
    /// Pictures take no more than this of a page, as PNG; what comes later is named and left out.
    static constexpr std::size_t most_picture_bytes = 24'000'000;

    /// kind: what made it, such as "ddtool slam".
    Page(std::string kind, std::string title);

    /// What follows stands under the heading.
    Page& section(const std::string& heading);
    /// A paragraph; nothing for an empty one.
    Page& text(const std::string& words);
    /// What the reader should know before he trusts the rest; nothing for none.
    Page& warnings(std::span<const std::string> lines);
    /// Figures at a glance.
    Page& facts(std::span<const Fact> facts);
    /// Nothing for one without rows.
    Page& table(const Table& table);
    Page& pictures(std::span<const Picture> pictures);
    /// Small, side by side, each with a button that leads to its row.
    Page& moments(std::span<const Moment> moments);
    /// Settings, versions and the like, folded: a row a value, by its path.
    Page& values(const std::string& title, const Json& values);
    /// A map and time lines to explore (docs/reports.md); one a page.
    Page& explorer(const Json& data);

    [[nodiscard]] std::string html() const;
    /// Written beside and renamed. Throws Error naming the file.
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

/// Makes a page and writes it. Results are worth more than a report of them, so whatever goes wrong is a warning, and a
/// page of an earlier run is removed. Returns whether the page is there.
bool write_page(const std::filesystem::path& file, const std::function<Page()>& make);

}  // namespace ddtool::html
