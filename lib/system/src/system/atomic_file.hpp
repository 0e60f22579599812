#pragma once

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iosfwd>
#include <string_view>

#include "ddtool/base/error.hpp"

namespace ddtool {

/// A file cannot be written, for example because the disk is full or the folder is read-only. The next file would fail
/// for the same reason, so this error ends a whole command, even one that goes on when a single run has failed.
class OutputError : public Error {
public:
    explicit OutputError(const std::string& what) : Error(what) {}
};

/// A file that appears under its name only when it is complete: it is written beside its place as NAME.part, flushed,
/// and then renamed. If the object is destroyed without commit(), the part is removed, and an older file of that name
/// stays as it was. For one thread at a time.
class AtomicFile {
public:
    /// Removes a part that an earlier program has left behind. If that part were a link, the data would be written to
    /// the place that it points to. Throws OutputError if the path is a device, a pipe or a socket.
    explicit AtomicFile(std::filesystem::path path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// The path to write to until commit(). The file is not created yet.
    [[nodiscard]] const std::filesystem::path& part() const { return part_; }
    /// Syncs the part to disk and renames it. Throws OutputError naming the file and the system's reason.
    void commit();

private:
    std::filesystem::path path_;
    std::filesystem::path part_;
    bool committed_ = false;
};

/// An AtomicFile that is written piece by piece. Throws OutputError naming the file and the system's reason if writing
/// fails. For one thread at a time.
class AtomicStream {
public:
    explicit AtomicStream(const std::filesystem::path& path);
    /// Calls write(std::ostream&), and throws OutputError if the stream has failed afterwards.
    template <typename Write>
    void write(Write&& write) {
        errno = 0;
        write(stream_);
        expect_written();
    }
    /// Completes the file, which then appears under its name. Without close() nothing is left behind.
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

/// Returns the content of the whole file. Throws Error naming the file and the system's reason if it cannot be read.
std::string read_file(const std::filesystem::path& path);

}  // namespace ddtool
