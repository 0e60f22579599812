#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ddtool {

/// Keeps the stamps of a robot's messages continuous where the clock that made them jumps: because it is set, or
/// because the lidar or the robot has been started again. A clock has jumped by more than least_jump_s where a stamp
/// lies before the one before it, or where it arrives earlier after its stamp than all others of late; a message that
/// was delayed does neither. Sources whose clock jumps together stay as simultaneous as they were.
class StampWatch {
public:
    static constexpr double least_jump_s = 1.0;

    struct Jump {
        std::string source;
        double by_s = 0.0;
    };

    /// \param simulated the clock is that of a simulator: it may run at any speed and stand still, so that only a step
    /// back is a jump
    explicit StampWatch(bool simulated) : simulated_(simulated) {}

    /// What has to be added to this stamp. Stamps of one source rise.
    /// \param arrived_ns when the message arrived, by a clock that does not jump
    std::int64_t offset_ns(const std::string& source, std::int64_t stamp_ns, std::int64_t arrived_ns);
    /// A jump that the last call has found, if nobody had found it before.
    [[nodiscard]] const std::optional<Jump>& new_jump() const { return new_jump_; }
    /// What was added to the latest stamp of a source; 0 if there was none.
    [[nodiscard]] std::int64_t offset_of(const std::string& source) const;

private:
    struct Source {
        std::int64_t offset_ns = 0;
        std::int64_t last_ns = 0;       ///< of the latest stamp, with the offset
        std::int64_t arrived_ns = 0;    ///< of the latest message
        std::int64_t interval_ns = 0;   ///< between the latest two stamps
        std::int64_t least_lag_ns = 0;  ///< between a stamp, with the offset, and its arrival, of late
    };

    [[nodiscard]] bool goes_on(const Source& source, std::int64_t stamp_ns, std::int64_t arrived_ns) const;
    std::int64_t offset_after_jump(const Source& source, std::int64_t stamp_ns, std::int64_t arrived_ns);

    bool simulated_;
    std::map<std::string, Source> sources_;
    std::vector<std::int64_t> offsets_{0};  ///< all that were found, the latest last
    std::optional<Jump> new_jump_;
};

}  // namespace ddtool
