#include <exception>
#include <iostream>

#include "train/history.hpp"

/// Writes the history of a training of three epochs into the folder, and then that of five epochs over it, as a
/// training that goes on does.
int main(int argc, char** argv) {
    try {
        if (argc != 2) {
            std::cerr << "usage: write_history FOLDER\n";
            return 2;
        }
        std::vector<ddtool::train::EpochRecord> epochs;
        for (std::uint64_t epoch = 1; epoch <= 5; ++epoch) {
            const auto number = static_cast<double>(epoch);
            epochs.push_back({epoch, 1e-3 / number, 0.7 / number, 1.0 - 0.3 / number, 0.8 / number, 1.0 - 0.4 / number,
                              1.0 - 0.5 / number, 1.0 - 0.1 / number, 12.5, 1.7e9 + 12.5 * number});
            if (epoch == 3 || epoch == 5) {
                ddtool::train::write_history(argv[1], epochs);
            }
        }
        return 0;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
