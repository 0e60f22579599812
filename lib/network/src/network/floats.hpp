#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace ddtool::network {

/// Aligns memory to cache lines, since vectors that cross a line take twice as long to load.
template <typename T>
struct CacheLineAllocator {
    using value_type = T;
    static constexpr std::align_val_t alignment{64};

    CacheLineAllocator() = default;
    template <typename Other>
    explicit CacheLineAllocator(const CacheLineAllocator<Other>& /*other*/) {}

    T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), alignment)); }
    void deallocate(T* memory, std::size_t /*count*/) { ::operator delete(memory, alignment); }
    bool operator==(const CacheLineAllocator& /*other*/) const { return true; }
};

using Floats = std::vector<float, CacheLineAllocator<float>>;

}  // namespace ddtool::network
