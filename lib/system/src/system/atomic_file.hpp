#pragma once

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iosfwd>
#include <string_view>

#include "ddtool/base/error.hpp"

namespace ddtool {

/// What was to be written cannot be: the disk is full, the folder read-only. It would not be otherwise for the next
/// file, so it ends a command even where one failed run among many does not.
class OutputError : public Error {
public:
    explicit OutputError(const std::string& what) : Error(what) {}
};

/// A file that appears under its name only when it is whole: written beside as NAME.part, flushed, then renamed.
/// Destroyed without commit(), the part is removed and an older file of that name stays as it was.
class AtomicFile {
public:
    /// A part that an earlier program left is removed; were it a link, what is written would go where it points.
    explicit AtomicFile(std::filesystem::path path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Where to write until commit(). Not yet created.
    [[nodiscard]] const std::filesystem::path& part() const { return part_; }
    /// Syncs the part to disk and renames it. Throws OutputError naming the file and the system's reason.
    void commit();

private:
    std::filesystem::path path_;
    std::filesystem::path part_;
    bool committed_ = false;
};

/// An AtomicFile that is written bit by bit. Throws OutputError naming the file and the system's reason when it cannot.
class AtomicStream {
public:
    explicit AtomicStream(const std::filesystem::path& path);
    /// Calls write(std::ostream&).
    template <typename Write>
    void write(Write&& write) {
        errno = 0;
        write(stream_);
        expect_written();
    }
    /// Completes the file.
    void close();

private:
    void expect_written() const;

    std::filesystem::path path_;
    AtomicFile file_;
    std::ofstream stream_;
};

/// Writes a whole file through AtomicFile. Throws OutputError naming the file and the system's reason when it cannot.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
void write_file(const std::filesystem::path& path, std::string_view content);

/// The whole file as bytes. Throws Error naming the file and the system's reason.
std::string read_file(const std::filesystem::path& path);

}  // namespace ddtool
