#include "system/checksums.hpp"

#include <gmock/gmock.h>

#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

using test::thrown_text;
using testing::HasSubstr;

TEST(Sha256, IsThatOfTheStandardsExamples) {  // the examples of FIPS 180-2, appendix B.1 and B.2
    EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(ListedChecksum, IsExpectedOfAListedFileAlone) {
    const test::TemporaryFolder folder;
    write_file(folder / "model.pt", "abc");
    write_file(folder / "mine.pt", "of my own");
    EXPECT_EQ(thrown_text([&] { expect_listed_checksum(folder / "model.pt"); }), "");
    write_file(folder / "SHA256SUMS", sha256_of("old") + "  old.pt\n" + sha256_of("abc") + "  model.pt\n");
    EXPECT_EQ(thrown_text([&] { expect_listed_checksum(folder / "model.pt"); }), "");
    EXPECT_EQ(thrown_text([&] { expect_listed_checksum(folder / "mine.pt"); }), "");
    write_file(folder / "model.pt", "abd");
    EXPECT_THAT(thrown_text([&] { expect_listed_checksum(folder / "model.pt"); }),
                HasSubstr("model.pt: damaged or another file"));
}

}  // namespace
}  // namespace ddtool
