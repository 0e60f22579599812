#include "localization/place_trust.hpp"

namespace ddtool::localization {

void PlaceTrust::add(double probability, double lost) {
    if (probability >= sure_probability) {
        state_ = PlaceState::found;
    } else if (probability < even_probability && state_ != PlaceState::searching) {
        state_ = lost >= even_probability ? PlaceState::lost : PlaceState::ambiguous;
    }
}

}  // namespace ddtool::localization
