#pragma once

namespace ddtool {

/// While one lives, the first Ctrl-C (SIGINT) or SIGTERM does not end the program but asks it to finish; the second
/// ends it as usual. Where several live, as a training inside a longer work, all of them are asked.
class InterruptRequest {
public:
    InterruptRequest();
    ~InterruptRequest();
    InterruptRequest(const InterruptRequest&) = delete;
    InterruptRequest& operator=(const InterruptRequest&) = delete;

    [[nodiscard]] bool made() const;
    /// Blocks until the request has been made.
    void wait() const;
};

}  // namespace ddtool
