#include "harness/gradebook/cbor_depth.h"

namespace harness {
namespace {

/// RFC 8949, section 3.1.
enum class Major { natural, negative, bytes, text, list, map, tag, simple };

}  // namespace

bool is_shallow_cbor(const std::vector<std::uint8_t>& bytes) {
    constexpr unsigned largest_in_head = 23, largest_with_length = 27;
    std::vector<std::uint64_t> awaited{1};  ///< by each list around this place, the outermost first
    std::size_t at = 0;
    while (!awaited.empty()) {
        if (awaited.back() == 0) {
            awaited.pop_back();
            continue;
        }
        --awaited.back();
        if (at == bytes.size()) return false;
        const unsigned head = bytes[at++];
        const Major major = static_cast<Major>(head >> 5U);
        std::uint64_t argument = head & 31U;
        if (major == Major::tag || argument > largest_with_length) return false;
        if (argument > largest_in_head) {
            const std::size_t size = std::size_t{1} << (argument - largest_in_head - 1);
            if (bytes.size() - at < size) return false;
            argument = 0;
            for (std::size_t i = 0; i < size; ++i) argument = argument << 8U | bytes[at++];
        }
        const std::size_t rest = bytes.size() - at;
        if (major == Major::bytes || major == Major::text) {
            if (argument > rest) return false;
            at += argument;
        } else if (major == Major::list || major == Major::map) {
            if (argument > rest || awaited.size() > deepest_cbor) return false;
            awaited.push_back(major == Major::map ? 2 * argument : argument);
        }
    }
    return at == bytes.size();
}

}  // namespace harness
