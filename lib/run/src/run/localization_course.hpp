#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "ddtool/filter/update.hpp"
#include "ddtool/system/settings.hpp"
#include "localization/localizer.hpp"
#include "localization/place_trust.hpp"
#include "report/page.hpp"
#include "system/atomic_file.hpp"

namespace ddtool {

/// Writes localization.csv, one row per update (docs/formats/results.md), and sums up how sure a localisation was of
/// its place. Every member throws OutputError that names the file if it cannot be written.
class LocalizationCourse {
public:
    /// A pose counts as sure from this probability on.
    static constexpr double sure = localization::sure_probability;
    /// The robot counts as lost from this probability on.
    static constexpr double lost = localization::even_probability;

    explicit LocalizationCourse(const std::filesystem::path& file);

    void add(const Update& update, const localization::Standing& standing);
    /// Completes the file. If this is never called, no file is left behind.
    void close() { file_.close(); }

    /// The form of run.json.
    [[nodiscard]] Json json() const;
    [[nodiscard]] std::vector<report::Fact> facts() const;
    /// Why the poses may be wrong, one line for each reason; empty if nothing speaks against them.
    [[nodiscard]] std::vector<std::string> doubts() const;

private:
    /// Stamps between which the robot counted as lost.
    struct Spell {
        std::int64_t from_ns = 0;
        std::int64_t to_ns = 0;
    };

    AtomicStream file_;
    std::size_t updates_ = 0;
    std::size_t sure_updates_ = 0;
    std::size_t searches_ = 0;
    std::size_t most_modes_ = 0;
    std::size_t particles_ = 0;  ///< of all updates together
    double way_m_ = 0.0;
    double support_ = 0.0;  ///< summed over the updates
    std::optional<double> way_until_sure_m_;
    std::int64_t start_ns_ = 0;
    bool was_sure_ = false;
    bool is_lost_ = false;
    std::vector<Spell> spells_;
    localization::Standing last_;
};

}  // namespace ddtool
