#include "system/atomic_file.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <new>
#include <stdexcept>

#include "temporary_folder.hpp"
#include "thrown_text.hpp"

// Allocations may leave a reason in errno although they succeed: glibc's do where the heap cannot grow at its place.
static thread_local bool allocations_set_errno = false;

void* operator new(std::size_t size) {
    void* const memory = std::malloc(size == 0 ? 1 : size);
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    errno = allocations_set_errno ? ENOMEM : errno;
    return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

namespace ddtool {
namespace {

using test::TemporaryFolder;
using test::thrown_text;
using testing::HasSubstr;

std::size_t files_in(const TemporaryFolder& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder / "."), {}));
}

TEST(WriteFile, ThereAndBackKeepsEveryByte) {
    const TemporaryFolder folder;
    std::string content;
    for (int byte = 0; byte < 256; ++byte) {
        content.push_back(static_cast<char>(byte));
    }
    write_file(folder / "a", content);
    EXPECT_EQ(read_file(folder / "a"), content);
    write_file(folder / "a", "");
    EXPECT_EQ(read_file(folder / "a"), "");
    EXPECT_EQ(files_in(folder), 1U);
}

TEST(WriteFile, FailureKeepsTheOldFileAndLeavesNoPart) {
    const TemporaryFolder folder;
    write_file(folder / "a", "old");
    EXPECT_THROW(write_file(folder / "a",
                            [](std::ostream& out) {
                                out << "half";
                                throw std::runtime_error("stopped");
                            }),
                 std::runtime_error);
    EXPECT_EQ(read_file(folder / "a"), "old");
    EXPECT_EQ(files_in(folder), 1U);
}

TEST(WriteFile, StreamThatFailedIsAnError) {
    const TemporaryFolder folder;
    const auto fail = [](std::ostream& out) { out.setstate(std::ios::badbit); };
    EXPECT_THAT(thrown_text([&] { write_file(folder / "a", fail); }), HasSubstr("a: cannot write"));
    EXPECT_EQ(files_in(folder), 0U);
}

TEST(WriteFile, ReplacesNoPipe) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_THAT(thrown_text([&] { write_file(folder / "pipe", "x"); }), HasSubstr("pipe: is a device, a pipe"));
    EXPECT_TRUE(std::filesystem::is_fifo(folder / "pipe"));
}

TEST(WriteFile, NamesTheFileAndTheReason) {
    const TemporaryFolder folder;
    EXPECT_THAT(thrown_text([&] { write_file(folder / "none/a", "x"); }), HasSubstr("none/a: cannot create: No such"));
    std::filesystem::create_directory(folder / "taken");
    EXPECT_THAT(thrown_text([&] { write_file(folder / "taken", "x"); }), HasSubstr("taken: cannot rename"));
    EXPECT_EQ(files_in(folder), 1U);
}

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
    const TemporaryFolder folder;
    AtomicFile file(folder / "a");
    std::ofstream(file.part()) << "new";
    EXPECT_FALSE(std::filesystem::exists(folder / "a"));
    file.commit();
    EXPECT_EQ(read_file(folder / "a"), "new");
}

TEST(AtomicFile, AfterCommitLeavesTheNextWritersPartAlone) {
    const TemporaryFolder folder;
    {
        AtomicFile file(folder / "a");
        std::ofstream(file.part()) << "first";
        file.commit();
        std::ofstream(file.part()) << "second, by another";
    }
    EXPECT_EQ(read_file(folder / "a.part"), "second, by another");
}

TEST(AtomicFile, DoesNotFollowALinkUnderThePartsName) {
    const TemporaryFolder folder;
    write_file(folder / "elsewhere", "precious");
    std::filesystem::create_symlink(folder / "elsewhere", folder / "a.part");
    write_file(folder / "a", "new");
    EXPECT_EQ(read_file(folder / "elsewhere"), "precious");
    EXPECT_EQ(read_file(folder / "a"), "new");
    EXPECT_FALSE(std::filesystem::is_symlink(folder / "a"));
}

TEST(ReadFile, NamesTheFileAndTheReason) {
    const TemporaryFolder folder;
    EXPECT_THAT(thrown_text([&] { read_file(folder / "none"); }), HasSubstr("none: cannot read: No such file"));
    EXPECT_THAT(thrown_text([&] { read_file(folder / "."); }), HasSubstr("cannot read: Is a directory"));
}

TEST(ReadFile, TakesNoReasonForAFailureFromWhatSucceeded) {
    const TemporaryFolder folder;
    const std::string content(300'000, 'x');
    write_file(folder / "a", content);
    allocations_set_errno = true;
    std::string read;
    EXPECT_NO_THROW(read = read_file(folder / "a"));
    allocations_set_errno = false;
    EXPECT_EQ(read, content);
}

}  // namespace
}  // namespace ddtool
