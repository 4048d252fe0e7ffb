// Memory that begins on a cache line.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace scanshade {

inline constexpr std::size_t cache_line = 64;

template <class T>
struct AlignedAllocator {
    using value_type = T;
    AlignedAllocator() = default;
    template <class U>
    AlignedAllocator(const AlignedAllocator<U>&) {}

    T* allocate(std::size_t n) {
        return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{cache_line}));
    }
    void deallocate(T* p, std::size_t) { ::operator delete (p, std::align_val_t{cache_line}); }
    bool operator==(const AlignedAllocator&) const { return true; }
};

/// A vector whose first element begins on a cache line, so that no store of a whole register there
/// touches two.
template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace scanshade
