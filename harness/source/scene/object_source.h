// How sources state a kind of object: the search for the scene's numbers asks this table about each kind. Each kind's
// file defines its functions.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "harness/source/scene/scene_part.h"
#include "harness/source/scene/stated_numbers.h"

namespace harness::source {

/// A student's name for a part of an object.
struct PartWords {
    std::string_view name;  ///< the handout's word for it
    /// Whether a variable of this name may well be this part. Never called for a name with another object's words.
    bool (*may_name)(std::string_view name);
    /// For a single number: whether nothing else in a program has such a name, so that another value makes it doubtful.
    bool is_only_so_called = false;
};

/// The results of the search so far.
struct FoundParts {
    std::vector<SceneLiteral> literals;
    std::vector<std::optional<ScenePart>> placed;  ///< for each vector of the source, its part by its neighbors
    PartSet doubtful;

    void take(const StatedNumber& number, ScenePart part, std::size_t component, bool splat = false, double offset = 0);

    /// Whether the part was found and is not doubtful.
    bool states(ScenePart part) const;
};

/// An object's part that a number's name may mean, if the window has one of the same name: both have a height.
struct NamedPart {
    ScenePart part;
    bool is_given;                ///< the number follows from the scene
    std::optional<double> value;  ///< the part's value according to the number; empty if that takes another number, too
};

struct ObjectSource {
    /// A row for each part, in the order of the object's fields.
    std::vector<PartWords> parts;
    /// A name that contains one of them means such an object, and no other.
    std::vector<std::string_view> words;
    /// Same for the type or name of a list of points; other names may contain them by chance.
    std::vector<std::string_view> words_of_lists = {};
    /// Whether a point whose name contains none of the words is taken for this object's only if it has the scene's
    /// value, because another kind of object has points with such names, too.
    bool needs_words = false;
    /// Finds the parts that the general search misses. The general search knows the fields one after the other in a
    /// list, a point's value and name, the numbers after a point, and numbers identified only by name. May be null.
    void (*find)(const SourceNumbers& numbers, const DecimalScene& scene, FoundParts& found) = nullptr;
    /// Parts that are written together or not at all.
    std::vector<ScenePart> together = {};
    /// The part that a number's name alone may mean. May be null.
    std::optional<NamedPart> (*named_part)(const DecimalScene& scene, std::string_view name, double value) = nullptr;
};

/// Each kind of object defines its own.
template <reference::Subject object>
const ObjectSource& source_of();

const ObjectSource& source_of(reference::Subject object);

}  // namespace harness::source
