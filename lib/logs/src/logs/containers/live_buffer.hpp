#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <streambuf>
#include <vector>

namespace ddtool {

/// Bytes that are still being made, read forward as they come. Both wait without hindering Ctrl-C: `stop` is asked
/// about twenty times a second, and ends the bytes once it says yes.
class LiveBuffer : public std::streambuf {
public:
    using Stop = std::function<bool()>;

    /// Standard input: ends where its writer closes it.
    static std::unique_ptr<LiveBuffer> standard_input(Stop stop);
    /// A file that another program appends to: ends at wait_no_more() only. Throws Error when it cannot be opened.
    static std::unique_ptr<LiveBuffer> followed(const std::filesystem::path& path, Stop stop);

    ~LiveBuffer() override;
    LiveBuffer(const LiveBuffer&) = delete;
    LiveBuffer& operator=(const LiveBuffer&) = delete;

    /// From now on what is there is all there is.
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
