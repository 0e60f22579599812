#include "logs/stream/stray_stamps.hpp"

#include <cmath>

#include "base/text.hpp"
#include "robot/stamps.hpp"

namespace ddtool {
namespace {

constexpr double far_s = 10.0;

std::string span_text(double span_s) {
    constexpr double day_s = 86400.0;
    constexpr double year_s = 365.25 * day_s;
    if (span_s > year_s) {
        return fixed_text(span_s / year_s, 1) + " years";
    }
    return span_s > day_s ? fixed_text(span_s / day_s, 1) + " days" : fixed_text(span_s, 1) + " s";
}

}  // namespace

StrayStamps::Found StrayStamps::add(std::int64_t stamp_ns, std::size_t lidar) {
    Course& course = courses_[lidar];
    if (++course.seen == 1) {
        course.believed_ns = stamp_ns;
        return {};
    }
    Found found;
    if (course.suspect_ns) {
        const double from_believed_s = std::abs(seconds_between(course.believed_ns, stamp_ns));
        const double from_suspect_s = std::abs(seconds_between(*course.suspect_ns, stamp_ns));
        found.before_was_stray = from_believed_s < from_suspect_s;
        if (found.before_was_stray) {
            count(course.suspect_number, seconds_between(course.believed_ns, *course.suspect_ns));
        } else {
            if (course.suspect_number == 2 && from_suspect_s < far_s) {  // then it was the first scan that strayed
                count(1, seconds_between(*course.suspect_ns, course.believed_ns));
            }
            course.believed_ns = *course.suspect_ns;
        }
        course.suspect_ns.reset();
    }
    if (std::abs(seconds_between(course.believed_ns, stamp_ns)) > far_s) {
        course.suspect_ns = stamp_ns;
        course.suspect_number = course.seen;
        found.is_suspect = true;
    } else {
        course.believed_ns = stamp_ns;
    }
    return found;
}

void StrayStamps::count(std::size_t number, double apart_s) {
    if (strays_++ == 0) {
        first_number_ = number;
        first_apart_s_ = apart_s;
    }
}

std::string StrayStamps::finding() const {
    if (strays_ == 0) {
        return "";
    }
    return std::to_string(strays_) + (strays_ == 1 ? " scan is" : " scans are") +
           " left out, stamped far away from the scans before and after, " +
           (strays_ == 1 ? "" : "the first of them ") + "number " + std::to_string(first_number_) + ", " +
           span_text(std::abs(first_apart_s_)) + (first_apart_s_ > 0.0 ? " ahead" : " behind");
}

}  // namespace ddtool
