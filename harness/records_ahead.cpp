#include "harness/records_ahead.h"

#include <algorithm>
#include <utility>

namespace harness {
namespace {

constexpr std::size_t part_size = 64;

}  // namespace

RecordsAhead::RecordsAhead(const std::vector<Graded>& graded, std::vector<std::size_t> places)
    : graded_(graded), places_(std::move(places)) {
    begin_part();
}

std::vector<std::vector<std::uint8_t>> RecordsAhead::encode(std::size_t begin) const {
    std::vector<std::vector<std::uint8_t>> records;
    for (std::size_t i = begin; i < std::min(begin + part_size, places_.size()); ++i)
        records.push_back(to_record(graded_[places_[i]]));
    return records;
}

void RecordsAhead::begin_part() {
    if (begun_ >= places_.size()) return;
    coming_ = std::async(std::launch::async, [this, begin = begun_] { return encode(begin); });
    begun_ += part_size;
}

std::vector<std::uint8_t> RecordsAhead::next() {
    if (taken_ == part_.size()) {
        part_ = coming_.get();
        taken_ = 0;
        begin_part();
    }
    return std::move(part_[taken_++]);
}

}  // namespace harness
