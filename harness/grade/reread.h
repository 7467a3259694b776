// Rereads: a person sets where an item is in the output, because raygrade misread it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "harness/match/item_place.h"
#include "harness/record/graded.h"

namespace harness {

/// Identifies the layout of an output as read, apart from its numbers (also nan and inf) and the width of its blanks.
std::string layout_of(std::string_view printout);

/// The places of those rereads that were made for the layout of this output.
std::vector<ItemPlace> places_in(const std::vector<Reread>& rereads, std::string_view printout);

/// The places of the submission's items in its output: from the rereads that were made for its layout, and for other
/// items from an experiment.
std::vector<ItemPlace> places_of(const Graded& graded, std::string_view printout);

/// Gives each submission its rereads. Rereads of other submissions are left out.
void attach(const std::vector<KeptReread>& rereads, std::vector<Submission>& submissions);
void attach(const std::vector<KeptReread>& rereads, std::vector<Graded>& graded);

}  // namespace harness
