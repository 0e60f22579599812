#include "logs/containers/db3_salvage.hpp"

#include <algorithm>

namespace ddtool {
namespace {

using Type = Db3Value::Type;

/// Whether the columns from the second on have these types. The first one is the id, which is stored as null.
bool has_types(const std::vector<Db3Value>& row, std::initializer_list<Type> types) {
    return row.size() > types.size() && row[0].type == Type::null &&
           std::equal(types.begin(), types.end(), row.begin() + 1,
                      [](Type type, const Db3Value& value) { return type == value.type; });
}

}  // namespace

Db3Salvage::Db3Salvage(std::span<const std::byte> file) : pages_(file) {
    for (std::uint32_t page = 1; page <= pages_.pages(); ++page) {
        const std::vector<Db3Cell> cells = pages_.cells(page);
        if (!cells.empty()) {
            leaves_.push_back({cells[cells.size() / 2].id, page});
        }
    }
    std::ranges::stable_sort(leaves_, {}, &Leaf::middle_id);
}

std::map<std::int64_t, McapChannel> Db3Salvage::topics() {
    std::map<std::int64_t, McapChannel> topics;
    for (const Leaf& leaf : leaves_) {
        for (const Db3Cell& cell : pages_.cells(leaf.page)) {
            const auto row = pages_.row(cell);
            // Of all rows that begin with three texts, only those of topics have a slash in front.
            if (row && has_types(*row, {Type::text, Type::text, Type::text}) && (*row)[1].text().starts_with('/')) {
                McapChannel& channel = topics[cell.id];
                channel.topic = (*row)[1].text();
                channel.schema.name = (*row)[2].text();
                channel.message_encoding = (*row)[3].text();
            }
        }
    }
    return topics;
}

std::optional<Db3Salvage::Message> Db3Salvage::next(std::int64_t after_id) {
    for (;;) {
        while (taken_ < cells_.size()) {
            const Db3Cell& cell = cells_[taken_++];
            const auto row = cell.id > after_id ? pages_.row(cell) : std::nullopt;
            if (row && has_types(*row, {Type::integer, Type::integer, Type::blob})) {
                return Message{cell.id, (*row)[1].integer, (*row)[2].integer, (*row)[3].bytes};
            }
        }
        if (opened_ == leaves_.size()) {
            return std::nullopt;
        }
        open_leaf();
    }
}

/// Ids beyond the middle of the next leaf are damaged, or a copy of rows that were moved there.
void Db3Salvage::open_leaf() {
    cells_ = pages_.cells(leaves_[opened_++].page);
    if (opened_ < leaves_.size()) {
        std::erase_if(cells_, [&](const Db3Cell& cell) { return cell.id >= leaves_[opened_].middle_id; });
    }
    std::ranges::stable_sort(cells_, {}, &Db3Cell::id);
    taken_ = 0;
}

double Db3Salvage::fraction_read() const {
    return leaves_.empty() ? 1.0 : static_cast<double>(opened_) / static_cast<double>(leaves_.size());
}

}  // namespace ddtool
