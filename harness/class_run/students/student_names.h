// What people call the submissions of a class, on a command line or in a list of students.
#pragma once

#include <map>
#include <set>
#include <string>

#include "harness/intake/submission.h"

namespace harness {

class StudentNames {
  public:
    void add(const Submission& submission);

    /// The id of the submission that is called so, by its id or by a student's name that only one has. Anything else
    /// comes back as it is: students choose their names, so a name that is a system's number or another's id counts as
    /// that.
    std::string id_of(const std::string& written) const;

    /// How many go by this name.
    std::size_t count(const std::string& name) const;

    /// A list by student, as a map: each name in it becomes the id, unless the list has that too.
    template <class List>
    void go_by_ids(List& list) const {
        List by_id;
        for (const auto& [called, what] : list) {
            const std::string id = id_of(called);
            by_id.emplace(list.contains(id) ? called : id, what);
        }
        list = std::move(by_id);
    }

  private:
    std::set<std::string> ids_, numbers_;
    std::multimap<std::string, std::string> ids_by_name_;
};

}  // namespace harness
