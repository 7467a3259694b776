// The variables of a source: which one a name means, and where it is set. As far as names and brackets tell; types and
// the order in which code runs are not known.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/source/code/words.h"

namespace harness::source {

/// A place that gives a variable its value.
struct Setting {
    std::size_t at = 0;  ///< the index of the word
    bool surely = true;  ///< false for an argument that a function may change
};

class Variables {
  public:
    /// Takes linear time, but for the nesting of brackets in declarations. `words` must outlive this object.
    explicit Variables(const std::vector<Word>& words);

    /// The index of the declaration that the name at `at` means; nowhere if it is no variable that the source declares
    /// before.
    std::size_t declaration_of(std::size_t at) const { return meaning_[at]; }

    /// Where the variable named at `at` is set before it is used there; one that is declared outside of all functions
    /// may be set anywhere. "hit.x" is set by "hit" and the other way round, but not by "hit.y".
    std::vector<Setting> settings_of(std::size_t at) const;

    /// The calls of the function of which the variable named at `at` is a parameter.
    std::vector<std::size_t> calls_of_parameter(std::size_t at) const;

  private:
    /// Each from its first word to past its last.
    using Parameters = std::vector<std::pair<std::size_t, std::size_t>>;
    struct Scopes;

    bool is(std::size_t at, std::string_view symbol) const { return is_symbol(words_, at, symbol); }
    bool is_plain_name(std::size_t at) const;
    std::size_t past_type(std::size_t at) const;
    void find_declarations();
    void declare_from(std::size_t begin);
    std::size_t name_of_function(std::size_t open) const;
    void find_functions();
    void open_scope(Scopes& scopes, std::size_t open) const;
    void find_meanings();
    std::size_t past_place(std::size_t at) const;
    std::string members_after(std::size_t at) const;
    bool is_set_by(std::size_t use) const;
    bool may_be_changed_as_argument(std::size_t use, bool known_functions) const;
    bool is_changeable(const Parameters& parameters, std::size_t argument) const;

    const std::vector<Word>& words_;
    std::vector<bool> declares_;                            ///< by index of a name
    std::vector<std::size_t> meaning_;                      ///< by index of a name
    std::map<std::size_t, std::vector<std::size_t>> uses_;  ///< by declaration, ascending, with itself
    std::map<std::string_view, Parameters> functions_;      ///< that the source defines
    std::map<std::size_t, std::pair<std::size_t, std::size_t>> parameters_of_body_;  ///< by bracket, the brackets
    std::map<std::size_t, std::string_view> function_of_parameter_;                  ///< by declaration
};

}  // namespace harness::source
