#include "train/training_state.hpp"

#include <algorithm>

namespace ddtool::train {

const EpochRecord* best_epoch(const TrainingState& state) {
    const auto best = std::min_element(
        state.history.begin(), state.history.end(),
        [](const auto& first, const auto& second) { return first.validation_loss < second.validation_loss; });
    return best == state.history.end() ? nullptr : &*best;
}

bool finished(const TrainingState& state) {
    const EpochRecord* const best = best_epoch(state);
    const std::size_t patience = state.settings.patience_epochs;
    const bool stuck = patience > 0 && best != nullptr && state.epoch - best->epoch >= patience;
    return stuck || state.epoch >= state.settings.epochs;
}

}  // namespace ddtool::train
