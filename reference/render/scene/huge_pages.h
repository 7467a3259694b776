// Arrays in huge pages where the kernel has them. A virtual machine takes some 5 µs for each page that is touched
// first, which for a mesh's tree is longer than to build it.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <vector>

namespace reference::render {

/// An allocator for std::vector.
template <class T>
struct HugePages {
    using value_type = T;

    HugePages() = default;
    template <class U>
    HugePages(const HugePages<U>& /*other*/) {}

    static constexpr std::size_t page = std::size_t{2} << 20U;

    static bool is_large(std::size_t count) { return count * sizeof(T) >= page; }

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        if (!is_large(count)) return static_cast<T*>(::operator new(bytes, std::align_val_t(alignof(T))));
        void* const array = ::operator new(bytes, std::align_val_t(page));
        madvise(array, bytes / page * page, MADV_HUGEPAGE);  // a wish: the rest of the last page may be somebody else's
        return static_cast<T*>(array);
    }

    void deallocate(T* array, std::size_t count) {
        ::operator delete(array, std::align_val_t(is_large(count) ? page : alignof(T)));
    }

    template <class U>
    bool operator==(const HugePages<U>& /*other*/) const {
        return true;
    }
};

template <class T>
using InHugePages = std::vector<T, HugePages<T>>;

}  // namespace reference::render
