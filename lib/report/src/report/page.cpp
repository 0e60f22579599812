#include "report/page.hpp"

#include <exception>
#include <system_error>
#include <utility>

#include "report/assets.hpp"
#include "report/data_uri.hpp"
#include "report/escape.hpp"
#include "system/atomic_file.hpp"
#include "system/failure_text.hpp"
#include "system/log.hpp"

namespace ddtool::report {
namespace {

/// The page's Content-Security-Policy. The browser loads nothing from outside of the page, even if a text in it should
/// contain markup that was not escaped.
constexpr const char* policy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

std::string element(const std::string& tag, const std::string& text) {
    return "<" + tag + ">" + html_escaped(text) + "</" + tag.substr(0, tag.find(' ')) + ">";
}

std::string id_of_section(std::size_t index) { return "section-" + std::to_string(index + 1); }

std::string table_row(const std::vector<std::string>& words, const std::vector<bool>& numeric, const std::string& tag) {
    std::string row = "<tr>";
    for (std::size_t column = 0; column < words.size(); ++column) {
        row += element(tag + (numeric[column] ? " class=\"number\"" : ""), words[column]);
    }
    return row + "</tr>\n";
}

std::string table_element(const Table::Words& words) {
    std::string text = "<table>\n<thead>\n" + table_row(words.lines.front(), words.numeric, "th scope=\"col\"") +
                       "</thead>\n<tbody>\n";
    for (const auto& line : std::span(words.lines).subspan(1)) {
        text += table_row(line, words.numeric, "td");
    }
    return text + "</tbody>\n</table>\n";
}

void add_values(Table& table, const std::string& path, const Json& value) {
    if (value.is_object()) {
        const std::string before = path.empty() ? "" : path + ".";
        for (const auto& [key, below] : value.items()) {
            add_values(table, std::string(before).append(key), below);
        }
    } else {
        const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
        table.add_row({path, value.is_string() ? value.get<std::string>() : text});
    }
}

}  // namespace

std::string folder_name(const std::filesystem::path& folder) {
    const std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
    return (path.has_filename() ? path : path.parent_path()).filename().string();
}

Picture picture_of_file(const std::string& title, const std::filesystem::path& file) {
    return {.title = title, .png = read_file(file), .caption = ""};
}

Page::Page(std::string kind, std::string title) : kind_(std::move(kind)), title_(std::move(title)) {}

Page& Page::section(const std::string& heading) {
    const std::string id = id_of_section(headings_.size());
    body_ += headings_.empty() ? "" : "</section>\n";
    body_ += "<section aria-labelledby=\"" + id + "\">\n" + element("h2 id=\"" + id + "\"", heading) + "\n";
    headings_.push_back(heading);
    return *this;
}

Page& Page::text(const std::string& words) {
    body_ += words.empty() ? "" : element("p", words) + "\n";
    return *this;
}

Page& Page::warnings(std::span<const std::string> lines) {
    if (!lines.empty()) {
        body_ += "<ul class=\"warnings\" aria-label=\"Warnings\">\n";
        for (const std::string& line : lines) {
            body_ += element("li", line) + "\n";
        }
        body_ += "</ul>\n";
    }
    return *this;
}

Page& Page::facts(std::span<const Fact> facts) {
    body_ += "<dl class=\"facts\">\n";
    for (const auto& [name, value] : facts) {
        body_ += "<div>" + element("dt", name) + element("dd", value) + "</div>\n";
    }
    body_ += "</dl>\n";
    return *this;
}

Page& Page::table(const Table& table) {
    if (table.empty()) {
        return *this;
    }
    const std::string name = headings_.empty() ? title_ : headings_.back();
    body_ += R"(<div class="wide" role="region" tabindex="0" aria-label=")" + html_escaped(name) + ", table\">\n" +
             table_element(table.words()) + "</div>\n";
    return *this;
}

Page& Page::pictures(std::span<const Picture> pictures) {
    body_ += "<div class=\"pictures\">\n";
    for (const Picture& picture : pictures) {
        figure(picture);
    }
    body_ += "</div>\n";
    return *this;
}

Page& Page::moments(std::span<const Moment> moments) {
    body_ += "<div class=\"pictures tiles\">\n";
    for (const auto& [picture, row] : moments) {
        figure(picture, R"(<button type="button" data-row=")" + std::to_string(row) +
                            "\" aria-label=\"Show on the map: " + html_escaped(picture.title) +
                            "\">Show on the map</button>");
    }
    body_ += "</div>\n";
    return *this;
}

void Page::figure(const Picture& picture, const std::string& button) {
    if (picture_bytes_ + picture.png.size() > most_picture_bytes) {
        text(picture.title + ": left out, the page would become too large.");
        return;
    }
    picture_bytes_ += picture.png.size();
    body_ += "<figure><img alt=\"" + html_escaped(picture.title) + "\" src=\"" + png_uri(picture.png) +
             "\">\n<figcaption>" + element("b", picture.title) + " " + html_escaped(picture.caption) + button +
             "</figcaption></figure>\n";
}

Page& Page::values(const std::string& title, const Json& values) {
    Table rows({{"name"}, {"value"}});
    add_values(rows, "", values);
    body_ += "<details>" + element("summary", title) + "\n";
    table(rows);
    body_ += "</details>\n";
    return *this;
}

Page& Page::explorer(const Json& data) {
    has_explorer_ = true;
    body_ +=
        "<noscript><p>The map and the time lines need JavaScript.</p></noscript>\n<div id=\"explorer\"></div>\n"
        "<script type=\"application/json\" id=\"explorer-data\">" +
        script_json(data) + "</script>\n";
    return *this;
}

std::string Page::navigation() const {
    std::string text = "<nav aria-label=\"Sections\"><ul>\n";
    for (std::size_t index = 0; index < headings_.size(); ++index) {
        text += "<li>" + element("a href=\"#" + id_of_section(index) + "\"", headings_[index]) + "</li>\n";
    }
    return text + "</ul></nav>\n";
}

std::string Page::html() const {
    std::string page =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"" +
        html_escaped(policy) + "\">\n<link rel=\"icon\" href=\"data:,\">\n" + element("title", title_ + " - " + kind_) +
        "\n<style>\n";
    page += style_sheet();
    page += "</style>\n</head>\n<body>\n<header>" + element("p", kind_) + element("h1", title_) + "</header>\n" +
            navigation() + "<main>\n" + body_ + (headings_.empty() ? "" : "</section>\n") + "</main>\n";
    if (has_explorer_) {
        page += "<script>\n" + explorer_script() + "</script>\n";
    }
    return page + "</body>\n</html>\n";
}

void Page::write(const std::filesystem::path& file) const { write_file(file, html()); }

bool write_page(const std::filesystem::path& file, const std::function<Page()>& make) {
    try {
        make().write(file);
        return true;
    } catch (const std::exception& error) {
        std::error_code ignored;
        std::filesystem::remove(file, ignored);
        log_warning("no report: " + failure_text(error));
        return false;
    }
}

}  // namespace ddtool::report
