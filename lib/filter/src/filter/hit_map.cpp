#include "ddtool/filter/hit_map.hpp"

namespace ddtool {

template <>
HitPatch* const CopyOnWrite<HitPatch>::empty_ = new HitPatch;  // never deleted: it is used as long as the program runs

void HitMap::reserve(Point2 low_m, Point2 high_m) {
    // One cell more to each side: add() writes to the neighbours, too.
    const auto first = [this](double along_m) { return (cell_of(along_m) - 1) >> HitPatch::size_bits; };
    const auto end = [this](double along_m) { return ((cell_of(along_m) + 1) >> HitPatch::size_bits) + 1; };
    patches_.reserve(first(low_m.x_m), first(low_m.y_m), end(high_m.x_m), end(high_m.y_m));
}

void HitMap::add(Point2 end_m) {
    const int x = cell_of(end_m.x_m);
    const int y = cell_of(end_m.y_m);
    HitPatch& patch = patches_.writable(x >> HitPatch::size_bits, y >> HitPatch::size_bits);
    const std::size_t cell = local(x, y);
    if ((patch.around[cell] >> own_bit & 1U) == 0) {
        patch.slot[cell] = static_cast<std::uint8_t>(patch.hits.size());
        patch.hits.emplace_back();
        mark(x, y);
    }
    HitPatch::Hits& hits = patch.hits[patch.slot[cell]];
    hits.sum_x_m += static_cast<float>(end_m.x_m);
    hits.sum_y_m += static_cast<float>(end_m.y_m);
    ++hits.count;
    const double share = 1.0 / hits.count;
    hits.mean_m = {share * static_cast<double>(hits.sum_x_m), share * static_cast<double>(hits.sum_y_m)};
}

/// Tells the cells about a cell that it has hits now.
void HitMap::mark(int x, int y) {
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int column = x + dx;
            const int row = y + dy;
            // Seen from the neighbour, this cell is on the opposite side.
            const int bit = 3 * (1 - dy) + 1 - dx;
            std::uint16_t& around =
                patches_.writable(column >> HitPatch::size_bits, row >> HitPatch::size_bits).around[local(column, row)];
            around = static_cast<std::uint16_t>(around | (1U << bit));
        }
    }
}

}  // namespace ddtool
