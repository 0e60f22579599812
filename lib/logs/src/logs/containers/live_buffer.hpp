#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <streambuf>
#include <vector>

namespace ddtool {

/// Bytes that are still being produced, read forward as they arrive. While waiting, it calls `stop` about twenty times
/// per second, and treats the bytes as ended once `stop` returns true, so that Ctrl-C works at any time.
class LiveBuffer : public std::streambuf {
public:
    using Stop = std::function<bool()>;

    /// Standard input; it ends when its writer closes it.
    static std::unique_ptr<LiveBuffer> standard_input(Stop stop);
    /// A file to which another program appends; it ends only after wait_no_more(). Throws Error if the file cannot be
    /// opened.
    static std::unique_ptr<LiveBuffer> followed(const std::filesystem::path& path, Stop stop);

    ~LiveBuffer() override;
    LiveBuffer(const LiveBuffer&) = delete;
    LiveBuffer& operator=(const LiveBuffer&) = delete;

    /// Declares that nothing more will be appended: the bytes end where the file ends now.
    void wait_no_more() { grows_ = false; }

protected:
    int_type underflow() override;

private:
    LiveBuffer(int descriptor, bool owned, bool grows, Stop stop);

    int descriptor_;
    bool owned_;
    bool grows_;  ///< at its end, more may come
    Stop stop_;
    std::vector<char> bytes_;
};

}  // namespace ddtool
