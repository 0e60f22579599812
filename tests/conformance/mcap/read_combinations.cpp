// read_mcap_combinations DIR EXPECTED_JSON: reads every MCAP file in DIR and compares its messages with the expected
// ones. The exit status is 1 if a file differs or is reported as damaged, or if DIR contains no such file.

#include <iostream>

#include "expected_messages.hpp"

namespace ddtool::test {
namespace {

/// What is wrong with the file; empty if it reads as expected.
std::string difference(const std::filesystem::path& file, const std::vector<OwnedMessage>& expected) {
    const ReadBack result = read_back_without_ids(file);
    if (result.error) {
        return *result.error;
    }
    if (!result.problems.empty()) {
        return result.problems.front().what;
    }
    return result.messages == expected ? "" : file.string() + ": holds other messages than expected";
}

int read_all(const std::filesystem::path& folder, const std::filesystem::path& expected_file) {
    const std::vector<OwnedMessage> expected = expected_messages(expected_file);
    std::size_t files = 0;
    std::size_t wrong = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string found = difference(entry.path(), expected);
        ++files;
        if (!found.empty()) {
            ++wrong;
            std::cerr << found << '\n';
        }
    }
    std::cout << files << " combinations read, " << wrong << " not as expected\n";
    return files > 0 && wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace ddtool::test

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: read_mcap_combinations DIR EXPECTED_JSON\n";
        return 2;
    }
    return ddtool::test::read_all(argv[1], argv[2]);
}
