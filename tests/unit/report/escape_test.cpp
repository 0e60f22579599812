#include "report/escape.hpp"

#include <gtest/gtest.h>

namespace ddtool::report {
namespace {

TEST(Escaped, LeavesNoCharacterThatMeansSomething) {
    EXPECT_EQ(html_escaped(R"(<a href="x">'&'</a>)"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
    EXPECT_EQ(html_escaped("Gebäude 079"), "Gebäude 079");
}

TEST(ScriptJson, IsTheSameValueAndCannotEndItsElement) {
    const Json value{{"</script><b>", {1, 2.5, "<!-- \"quoted\" & 'so'"}}, {"none", nullptr}};
    const std::string text = script_json(value);
    EXPECT_EQ(text.find('<'), std::string::npos);
    EXPECT_EQ(Json::parse(text), value);
}

TEST(ScriptJson, ReplacesWhatIsNotUtf8) { EXPECT_EQ(Json::parse(script_json(Json("a\xff"))), "a\xEF\xBF\xBD"); }

}  // namespace
}  // namespace ddtool::report
