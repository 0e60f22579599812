#pragma once

#include <atomic>
#include <cstdlib>
#include <new>

/// Replaces the program's operator new by one that counts the allocations. Include it in one file of a test program
/// only.
namespace ddtool::test {
inline std::atomic<int> allocations{0};
}  // namespace ddtool::test

// The operators are not inline: otherwise GCC would warn that new and delete do not match.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++ddtool::test::allocations;
    if (void* const memory = std::malloc(size)) {
        return memory;
    }
    throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
    ++ddtool::test::allocations;
    const auto step = static_cast<std::size_t>(alignment);
    if (void* const memory = std::aligned_alloc(step, (size + step - 1) / step * step)) {
        return memory;
    }
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
