#include "report/page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <new>

#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace ddtool::report {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* nasty = R"(</script><img src="http://x" onerror='a&b'>)";

TEST(Page, TakesEveryTextAsText) {
    Table table({{nasty}});
    table.add_row({std::string(nasty)});
    Page page(nasty, nasty);
    const std::array lines{std::string(nasty)};
    const std::array facts{Fact{nasty, nasty}};
    const std::array pictures{Picture{nasty, "png", nasty}};
    const std::array moments{Moment{pictures[0], 3}};
    page.warnings(lines).facts(facts).section(nasty).text(nasty).table(table).pictures(pictures).moments(moments);
    page.values(nasty, {{nasty, {{"key", nasty}}}}).explorer({{nasty, nasty}});
    const std::string html = page.html();
    EXPECT_THAT(html, Not(HasSubstr("<img src=\"http")));
    EXPECT_THAT(html, Not(HasSubstr("</script><")));
}

TEST(Page, LeadsToItsSections) {
    const std::string html = Page("kind", "title").section("one").text("words").section("two").html();
    EXPECT_THAT(html, HasSubstr("<a href=\"#section-2\">two</a>"));
    EXPECT_THAT(html, HasSubstr("<h2 id=\"section-2\">two</h2>"));
}

TEST(Page, HasScriptsForAnExplorerOnly) {
    EXPECT_THAT(Page("kind", "title").html(), Not(HasSubstr("<script")));
    EXPECT_THAT(Page("kind", "title").explorer(Json::object()).html(), HasSubstr("startExplorer();"));
}

TEST(Page, LeavesOutPicturesThatWouldMakeItTooLarge) {
    const std::array pictures{Picture{"first", std::string(Page::most_picture_bytes - 1, 'x'), ""},
                              Picture{"second", "xx", ""}, Picture{"third", "x", ""}};
    const std::string html = Page("kind", "title").pictures(pictures).html();
    EXPECT_THAT(html, HasSubstr("alt=\"first\""));
    EXPECT_THAT(html, HasSubstr("second: left out"));
    EXPECT_THAT(html, HasSubstr("alt=\"third\""));
}

TEST(WritePage, NeverThrowsAndLeavesNoPageOfAnEarlierRun) {
    const test::TemporaryFolder folder;
    EXPECT_TRUE(write_page(folder / "report.html", [] { return Page("kind", "title"); }));
    EXPECT_TRUE(std::filesystem::exists(folder / "report.html"));
    EXPECT_FALSE(write_page(folder / "report.html", []() -> Page { throw std::bad_alloc(); }));
    EXPECT_FALSE(std::filesystem::exists(folder / "report.html"));
    EXPECT_FALSE(write_page(folder / "missing/report.html", [] { return Page("kind", "title"); }));
}

}  // namespace
}  // namespace ddtool::report
