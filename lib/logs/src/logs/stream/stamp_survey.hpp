#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace ddtool {

/// a - b and a + b, computed without signs, because the stamps of a damaged log may be at the ends of what a signed
/// number can hold.
std::int64_t stamp_difference(std::int64_t a_ns, std::int64_t b_ns);
std::int64_t stamp_sum(std::int64_t a_ns, std::int64_t b_ns);

/// How the stamps of a topic are to be read.
struct StampRule {
    bool from_recording = false;   ///< they say nothing; the times of recording stand for them
    bool zero_is_a_stamp = false;  ///< as in simulated time; otherwise a stamp of 0 stands for none
    /// Where a stamp is missing, it is the time of recording moved by this, in nanoseconds.
    std::int64_t ahead_ns = 0;
    /// The stamps start again at 0 after this many nanoseconds; 0: never.
    std::int64_t period_ns = 0;
    std::string assumption;  ///< what is wrong with the stamps and what stands for them; empty: nothing is
    std::string fault;       ///< what is wrong with them and cannot be mended; empty: nothing is
};

/// Looks at the stamps of one topic, or of one transform, in the order of the log, beside the times at which its
/// messages were recorded. Memory does not grow with the log. Stamps are useless if they are
///   * missing: 0 throughout;
///   * all equal;
///   * wrapped: the remainder of nanoseconds, microseconds or milliseconds after division by 2^32, as a counter of 32
///     bits gives it. Then they step back by almost 2^32, and never reach it;
///   * rounded: multiples of a second or of 0.1 s, one of which several messages share, although they were recorded
///     one after the other. Finer rounding does no harm.
class StampSurvey {
public:
    /// \param has_stamp false: the message's stamp is 0
    void add(std::int64_t stamp_ns, bool has_stamp, std::int64_t recorded_ns);

    /// \param what names the topic in the texts: "the scans /scan"
    [[nodiscard]] StampRule rule(const std::string& what) const;
    /// The first and the last time of recording.
    [[nodiscard]] std::int64_t first_recorded_ns() const { return first_recorded_ns_; }
    [[nodiscard]] std::int64_t last_recorded_ns() const { return last_recorded_ns_; }

private:
    struct Unit {
        std::int64_t ns;
        bool divides_all = true;
    };
    struct Period {
        std::int64_t ns;
        std::size_t times = 0;      ///< how often the stamps started again after it
        std::size_t unlike_it = 0;  ///< steps back that it does not explain
    };

    void take_step(std::int64_t stamp_ns, std::int64_t recorded_ns);
    [[nodiscard]] bool recording_is_good() const;
    [[nodiscard]] const Unit* rounded_to() const;
    [[nodiscard]] const Period* wrapped_at() const;
    [[nodiscard]] double rounding_error_s() const;

    std::size_t messages_ = 0;
    std::size_t stamps_ = 0;            ///< that are not missing
    std::size_t missing_in_front_ = 0;  ///< before the first of these
    std::int64_t first_stamp_ns_ = 0;   ///< of these
    std::int64_t first_ahead_ns_ = 0;   ///< stamp minus time of recording there
    std::int64_t least_stamp_ns_ = 0;
    std::int64_t most_stamp_ns_ = 0;
    std::int64_t stamp_before_ns_ = 0;
    std::int64_t recorded_before_ns_ = 0;
    std::int64_t first_recorded_ns_ = 0;
    std::int64_t last_recorded_ns_ = 0;
    std::size_t steps_ = 0;  ///< between two stamps that follow one another
    std::size_t equal_ = 0;  ///< of these, without any difference
    std::size_t recorded_equal_ = 0;
    std::size_t recorded_back_ = 0;
    bool recorded_in_seconds_ = true;  ///< all times of recording are whole seconds
    double sum_ss_ = 0.0;              ///< of the products of the steps in s: of stamps, of both, of recording
    double sum_sr_ = 0.0;
    double sum_rr_ = 0.0;
    std::array<Unit, 2> units_{{{1'000'000'000}, {100'000'000}}};
    std::array<Period, 3> periods_{
        {{std::int64_t{1} << 32}, {1000 * (std::int64_t{1} << 32)}, {1'000'000 * (std::int64_t{1} << 32)}}};
};

/// Reads the stamps of a topic by a rule, in the order of the log.
class StampReader {
public:
    StampReader() = default;
    explicit StampReader(StampRule rule) : rule_(std::move(rule)) {}

    std::int64_t time_ns(std::int64_t stamp_ns, bool has_stamp, std::int64_t recorded_ns);

private:
    StampRule rule_;
    std::int64_t before_ns_ = 0;  ///< the stamp before
    std::int64_t passed_ns_ = 0;  ///< the periods that have passed
};

}  // namespace ddtool
