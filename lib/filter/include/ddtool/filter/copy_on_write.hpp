#pragma once

#include <atomic>
#include <cstdint>
#include <utility>

namespace ddtool {

/// Shared ownership of a patch of cells, one pointer wide. Unlike std::shared_ptr's use_count(), the count that
/// writable() reads synchronises with the release by other owners, so a thread that finds itself the only owner may
/// write. A single CopyOnWrite must not be used by two threads at once. A Content counts its owners in a member
/// `owners`, a std::atomic<std::uint32_t> that is 1 in every new object, copies included.
template <typename Content>
// NOLINTNEXTLINE(cppcoreguidelines-special-member-functions): the one assignment copies and moves.
class CopyOnWrite {
public:
    CopyOnWrite() noexcept : patch_(empty_patch()) { add_owner(); }
    CopyOnWrite(const CopyOnWrite& other) noexcept : patch_(other.patch_) { add_owner(); }
    CopyOnWrite(CopyOnWrite&& other) noexcept : patch_(std::exchange(other.patch_, nullptr)) {}
    CopyOnWrite& operator=(CopyOnWrite other) noexcept {
        std::swap(patch_, other.patch_);
        return *this;
    }
    ~CopyOnWrite() { release(); }

    const Content& operator*() const { return *patch_; }
    const Content* operator->() const { return patch_; }
    [[nodiscard]] bool empty() const { return patch_ == empty_patch(); }

    /// The patch for writing. If it is shared, this pointer gets its own copy first.
    Content& writable() {
        if (patch_->owners.load(std::memory_order_acquire) != 1) {
            *this = CopyOnWrite(new Content(*patch_));
        }
        return *patch_;
    }

private:
    explicit CopyOnWrite(Content* patch) noexcept : patch_(patch) {}
    void add_owner() noexcept { patch_->owners.fetch_add(1, std::memory_order_relaxed); }
    void release() noexcept {
        if (patch_ != nullptr && patch_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) {
            delete patch_;
        }
    }
    /// The patch that stands for unknown ground everywhere. It always has one extra owner, so it is copied before every
    /// write.
    static Content* empty_patch() noexcept { return empty_; }
    static Content* const empty_;

    Content* patch_;
};

}  // namespace ddtool
