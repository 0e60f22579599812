#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "ddtool/filter/copy_on_write.hpp"

namespace ddtool {

/// Where the nearest occupied point lies as seen from a cell's centre, in units of 1/32 of a cell.
struct NearestPoint {
    static constexpr std::int8_t none_mark = -128;
    static constexpr int units_per_cell = 32;

    std::int8_t x = none_mark;
    std::int8_t y = 0;

    [[nodiscard]] bool none() const { return x == none_mark; }
    bool operator==(const NearestPoint&) const = default;
};

/// Memory in bytes of all maps of the process: patches, each counted once however many particles share it, and the
/// tables of pointers to them. Any thread may read it at any time.
struct MapBytes {
    inline static std::atomic<std::size_t> live = 0;
};

/// Adds what a container allocates to MapBytes::live.
template <typename Value>
struct CountedAllocator {
    using value_type = Value;

    CountedAllocator() = default;
    template <typename Other>
    explicit CountedAllocator(const CountedAllocator<Other>& /*other*/) noexcept {}

    Value* allocate(std::size_t count) {
        Value* const place = std::allocator<Value>().allocate(count);
        MapBytes::live.fetch_add(count * sizeof(Value), std::memory_order_relaxed);
        return place;
    }
    void deallocate(Value* place, std::size_t count) noexcept {
        MapBytes::live.fetch_sub(count * sizeof(Value), std::memory_order_relaxed);
        std::allocator<Value>().deallocate(place, count);
    }
    bool operator==(const CountedAllocator& /*other*/) const = default;
};

/// A square of cells that particles share until one of them writes.
struct Patch {
    static constexpr int size_bits = 4;
    static constexpr int size_cells = 1 << size_bits;
    static constexpr int local_mask = size_cells - 1;
    static constexpr std::int8_t unknown = -128;
    static constexpr std::size_t cell_count = static_cast<std::size_t>(size_cells) * size_cells;

    Patch() {
        log_odds.fill(unknown);
        MapBytes::live.fetch_add(sizeof(Patch), std::memory_order_relaxed);
    }
    Patch(const Patch& other) : log_odds(other.log_odds), nearest(other.nearest) {
        MapBytes::live.fetch_add(sizeof(Patch), std::memory_order_relaxed);
    }
    Patch& operator=(const Patch&) = delete;
    ~Patch() { MapBytes::live.fetch_sub(sizeof(Patch), std::memory_order_relaxed); }

    /// Index of a cell in the arrays, from its coordinates in the whole grid.
    static std::size_t local(int cell_x, int cell_y) {
        return static_cast<std::size_t>(cell_y & local_mask) * size_cells +
               static_cast<std::size_t>(cell_x & local_mask);
    }

    /// The coordinate, in the whole grid, of the first cell in the next patch.
    static int next(int cell) { return (cell | local_mask) + 1; }

    std::array<std::int8_t, cell_count> log_odds;
    std::array<NearestPoint, cell_count> nearest{};
    std::atomic<std::uint32_t> owners = 1;
};

using PatchPointer = CopyOnWrite<Patch>;
template <>
Patch* const CopyOnWrite<Patch>::empty_;

/// The patches of one map, row by row.
using PatchTable = std::vector<PatchPointer, CountedAllocator<PatchPointer>>;

}  // namespace ddtool
