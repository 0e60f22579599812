#pragma once

namespace ddtool {

/// While an object of this class exists, the first Ctrl-C (SIGINT) or SIGTERM does not end the program but asks it to
/// finish; the second one ends it as usual. If there are several objects, such as that of a training within a longer
/// job, all of them report the request.
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
