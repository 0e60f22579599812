#include "base/pattern.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace ddtool {
namespace {

TEST(Expand, PutsWorldAndSeedInEveryPlace) {
    EXPECT_EQ(expand("{world}/{seed}-{seed}.tum", "s2", 17), "s2/17-17.tum");
    EXPECT_EQ(expand("random:office:17", "s2", 3), "random:office:17");
}

TEST(Expand, DoesNotLookIntoWhatItPutIn) { EXPECT_EQ(expand("{world}", "{world}", 1), "{world}"); }

TEST(FileNameOf, KeepsOnlyWhatIsSafe) { EXPECT_EQ(file_name_of("random:office/1 a-b_c.d"), "random_office_1_a-b_c.d"); }

TEST(FileNameOf, StaysInTheFolderWhateverTheName) {
    for (const std::string name : {"../../etc/passwd", "/etc/passwd", "a/../../b", "..\\b", "a\nb"}) {
        const std::filesystem::path file = "pictures/" + file_name_of(name) + "-maps.png";
        EXPECT_EQ(file.parent_path(), "pictures") << name;
        EXPECT_EQ(file.lexically_normal(), file) << name;
    }
}

}  // namespace
}  // namespace ddtool
