#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "logs/containers/db3_pages.hpp"
#include "logs/containers/mcap_types.hpp"

namespace ddtool {

/// The topics and messages of a damaged rosbag2 database, found in all of its pages. Debian's SQLite has no recovery
/// extension, and without it gives nothing of a tree below a page that is damaged or missing.
class Db3Salvage {
public:
    /// A row of the table of messages.
    struct Message {
        std::int64_t id = 0;
        std::int64_t topic = 0;
        std::int64_t time_ns = 0;
        std::span<const std::byte> data;  ///< valid until the next message
    };

    /// Looks through the pages.
    /// \param file the database, which must stay valid
    explicit Db3Salvage(std::span<const std::byte> file);

    /// The rows of the table of topics, by their id.
    [[nodiscard]] std::map<std::int64_t, McapChannel> topics();
    /// The next message whose id is greater than `after_id`, in the order of the ids, which is that of recording;
    /// nullopt at the end.
    std::optional<Message> next(std::int64_t after_id);
    /// The share of the pages with messages that has been read, 0..1.
    [[nodiscard]] double fraction_read() const;

private:
    struct Leaf {
        std::int64_t middle_id = 0;  ///< of the cell in its middle, so that single damaged cells do not misplace it
        std::uint32_t page = 0;
    };
    void open_leaf();

    Db3Pages pages_;
    std::vector<Leaf> leaves_;  ///< the leaf pages of tables, in the order of their ids
    std::size_t opened_ = 0;
    std::vector<Db3Cell> cells_;  ///< of the leaf that is being read, up to the middle of the next one
    std::size_t taken_ = 0;
};

}  // namespace ddtool
