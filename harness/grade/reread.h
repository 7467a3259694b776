// Rereads: a person says where an item stands in a printout that was misread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "harness/match/item_place.h"
#include "harness/record/graded.h"

namespace harness {

/// Identifies what a printout looks like, as it is read, apart from its numbers, nan and inf included, and from the
/// width of its blanks.
std::string layout_of(std::string_view printout);

/// The places of those rereads that were made for the layout of this printout.
std::vector<ItemPlace> places_in(const std::vector<Reread>& rereads, std::string_view printout);

/// The places of the submission's items in its printout: those of the rereads that were made for its layout, and of
/// other items those that an experiment shows.
std::vector<ItemPlace> places_of(const Graded& graded, std::string_view printout);

/// Gives each submission its rereads. Those of others are left out.
void attach(const std::vector<KeptReread>& rereads, std::vector<Submission>& submissions);
void attach(const std::vector<KeptReread>& rereads, std::vector<Graded>& graded);

}  // namespace harness
