#pragma once

namespace ddtool::localization {

/// A pose counts as sure from this probability on.
inline constexpr double sure_probability = 0.9;
/// Below this probability another place, or none of the map, is the more probable one.
inline constexpr double even_probability = 0.5;

/// Whether others may rely on a pose in a known map.
enum class PlaceState {
    searching,  ///< the robot has not been found yet
    found,
    ambiguous,  ///< it had been found, and now other places have together as much weight
    lost        ///< it had been found, and now the map explains its scans at none of the places that are followed
};

/// A robot is found from the first sure pose on, or when somebody tells where it is, until its pose is more probably
/// wrong than right. In between the state stays, so that it does not flicker.
class PlaceTrust {
public:
    /// Somebody has told where the robot is.
    void told() { state_ = PlaceState::found; }
    /// \param probability that the pose is right
    /// \param lost the probability that the robot is at none of the places that are followed
    void add(double probability, double lost);

    [[nodiscard]] PlaceState state() const { return state_; }

private:
    PlaceState state_ = PlaceState::searching;
};

}  // namespace ddtool::localization
