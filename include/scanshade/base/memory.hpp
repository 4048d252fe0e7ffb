// The memory of this process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

namespace scanshade {

/// The most that was ever resident, in bytes; 0 where the system does not say.
std::uint64_t peak_memory_bytes();

/// From now on this process gets no more than what is available now. What asks for more gets
/// std::bad_alloc, which is an error in a sentence, before the machine swaps or the system ends
/// whichever process it likes.
void limit_memory();

/// Memory that std::free gives back, on a cache line's boundary. Where it is large and the system has
/// huge pages to give it lies in such, so that fewer addresses are looked up. Throws std::bad_alloc.
void* allocate_large(std::size_t bytes);

/// For arrays that may be as large as a scene or a picture, and those that whole registers are stored into.
template <class T>
struct LargeAllocator {
    using value_type = T;
    LargeAllocator() = default;
    template <class U>
    LargeAllocator(const LargeAllocator<U>&) {}
    T* allocate(std::size_t count) {
        if (count > std::size_t(-1) / 2 / sizeof(T)) throw std::bad_alloc();
        return static_cast<T*>(allocate_large(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t) { std::free(memory); }
    template <class U>
    bool operator==(const LargeAllocator<U>&) const {
        return true;
    }
};
template <class T>
using LargeVector = std::vector<T, LargeAllocator<T>>;

}  // namespace scanshade
