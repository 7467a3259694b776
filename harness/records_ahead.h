// The records of a class, encoded while the gradebook's database is busy with those before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <future>
#include <vector>

#include "harness/graded_record.h"

namespace harness {

/// Gives to_record of these submissions of a class, one after the other. A thread of its own encodes the part
/// behind the one at hand and no more, so that a large class is never in memory as records.
class RecordsAhead {
  public:
    /// `places` are those wanted, in the order of the calls. The class stays as it is while this lives.
    RecordsAhead(const std::vector<Graded>& graded, std::vector<std::size_t> places);

    /// The record of the next place; called at most once for each.
    std::vector<std::uint8_t> next();

  private:
    std::vector<std::vector<std::uint8_t>> encode(std::size_t begin) const;
    void begin_part();

    const std::vector<Graded>& graded_;
    std::vector<std::size_t> places_;
    std::size_t begun_ = 0;  ///< how many of the places have been given to the thread
    std::size_t taken_ = 0;  ///< of the part at hand
    std::vector<std::vector<std::uint8_t>> part_;
    std::future<std::vector<std::vector<std::uint8_t>>> coming_;
};

}  // namespace harness
