#include "logs/containers/text_source.hpp"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

#include "ddtool/base/error.hpp"
#include "system/folder.hpp"

namespace ddtool {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

struct CloseGzip {
    void operator()(gzFile_s* file) const { ::gzclose(file); }
};

struct CloseBzip2 {
    void operator()(BZFILE* stream) const {
        int code = BZ_OK;
        ::BZ2_bzReadClose(&code, stream);
    }
};

File open_file(const std::filesystem::path& path) {
    if (is_folder(path)) {
        throw Error(path.string() + ": is a folder; expected a log file");
    }
    errno = 0;
    File file(std::fopen(path.c_str(), "rbe"));
    if (!file) {
        throw Error(path.string() + ": cannot open: " + std::strerror(errno));
    }
    return file;
}

double fraction(double offset, std::uintmax_t size) {
    return size == 0 ? 1.0 : std::clamp(offset / static_cast<double>(size), 0.0, 1.0);
}

LogProblem damage(const std::filesystem::path& path, const std::string& format, std::uintmax_t offset,
                  std::uintmax_t size) {
    return {path.string() + ": " + format + " data cut off or damaged near byte " + std::to_string(offset) + " of " +
                std::to_string(size) + "; the rest cannot be read",
            offset, size - std::min(offset, size)};
}

/// Reads plain and gzip files; zlib passes plain content through unchanged.
class GzipSource : public TextSource {
public:
    GzipSource(const std::filesystem::path& path, LogProblemHandler on_problem)
        : path_(path), on_problem_(std::move(on_problem)), size_(std::filesystem::file_size(path)) {
        file_.reset(::gzopen(path.c_str(), "rbe"));
        if (!file_) {
            throw Error(path.string() + ": cannot open: " + std::strerror(errno));
        }
        ::gzbuffer(file_.get(), 1U << 17U);
    }

    std::size_t read(std::span<char> buffer) override {
        const auto wanted = static_cast<unsigned>(std::min<std::size_t>(buffer.size(), 1U << 30U));
        const int got = ::gzread(file_.get(), buffer.data(), wanted);
        if (!ended_ && (got < 0 || static_cast<unsigned>(got) < wanted)) {
            ended_ = true;
            report_damage();
        }
        return static_cast<std::size_t>(std::max(got, 0));
    }
    [[nodiscard]] double fraction_read() const override {
        return fraction(static_cast<double>(::gzoffset(file_.get())), size_);
    }

private:
    void report_damage() const {
        int code = Z_OK;
        ::gzerror(file_.get(), &code);
        if (code != Z_OK && code != Z_STREAM_END) {
            const auto offset = static_cast<std::uintmax_t>(::gzoffset(file_.get()));
            on_problem_(damage(path_, "gzip", offset, size_));
        }
    }

    std::filesystem::path path_;
    LogProblemHandler on_problem_;
    std::uintmax_t size_;
    std::unique_ptr<gzFile_s, CloseGzip> file_;
    bool ended_ = false;
};

/// Reads one or more bzip2 streams in a row, as bzip2 and pbzip2 write them.
class Bzip2Source : public TextSource {
public:
    Bzip2Source(const std::filesystem::path& path, LogProblemHandler on_problem)
        : path_(path),
          on_problem_(std::move(on_problem)),
          size_(std::filesystem::file_size(path)),
          file_(open_file(path)) {
        open_stream({});
    }

    std::size_t read(std::span<char> buffer) override {
        std::size_t filled = 0;
        while (stream_ && filled < buffer.size()) {
            filled += read_stream(buffer.subspan(filled));
        }
        return filled;
    }
    [[nodiscard]] double fraction_read() const override {
        return fraction(static_cast<double>(std::ftell(file_.get())), size_);
    }

private:
    std::size_t read_stream(std::span<char> buffer) {
        const auto wanted = static_cast<int>(std::min<std::size_t>(buffer.size(), 1U << 30U));
        int code = BZ_OK;
        const int got = ::BZ2_bzRead(&code, stream_.get(), buffer.data(), wanted);
        if (code == BZ_STREAM_END) {
            next_stream();
        } else if (code != BZ_OK) {
            on_problem_(damage(path_, "bzip2", static_cast<std::uintmax_t>(std::ftell(file_.get())), size_));
            stream_.reset();
            return 0;
        }
        return static_cast<std::size_t>(got);
    }

    void next_stream() {
        int code = BZ_OK;
        void* unused = nullptr;
        int unused_size = 0;
        ::BZ2_bzReadGetUnused(&code, stream_.get(), &unused, &unused_size);
        const std::string rest(static_cast<const char*>(unused), static_cast<std::size_t>(unused_size));
        stream_.reset();
        if (!rest.empty() || !at_end_of_file()) {
            open_stream(rest);
        }
    }

    bool at_end_of_file() {
        const int next = std::fgetc(file_.get());
        std::ungetc(next, file_.get());
        return next == EOF;
    }

    void open_stream(std::string rest) {
        int code = BZ_OK;
        stream_.reset(::BZ2_bzReadOpen(&code, file_.get(), 0, 0, rest.data(), static_cast<int>(rest.size())));
        if (code != BZ_OK) {
            throw Error(path_.string() + ": cannot start reading bzip2 data");
        }
    }

    std::filesystem::path path_;
    LogProblemHandler on_problem_;
    std::uintmax_t size_;
    File file_;
    std::unique_ptr<BZFILE, CloseBzip2> stream_;  // declared after file_, so that it is closed first
};

bool is_bzip2(const std::filesystem::path& path) {
    constexpr std::string_view magic = "BZh";
    std::array<char, magic.size()> head{};
    const std::size_t got = std::fread(head.data(), 1, head.size(), open_file(path).get());
    return std::string_view(head.data(), got) == magic;
}

}  // namespace

std::unique_ptr<TextSource> open_text(const std::filesystem::path& path, LogProblemHandler on_problem) {
    if (is_bzip2(path)) {
        return std::make_unique<Bzip2Source>(path, std::move(on_problem));
    }
    return std::make_unique<GzipSource>(path, std::move(on_problem));
}

}  // namespace ddtool
