// The names that people use for submissions, on a command line or in a list of students.
#pragma once

#include <map>
#include <set>
#include <string>

#include "harness/intake/submission.h"

namespace harness {

class StudentNames {
  public:
    void add(const Submission& submission);

    /// The id of the submission with this id or with this student's name, if only one has it. Returns anything else
    /// unchanged. Students choose their names, so a name that equals an LMS number or another submission's id counts as
    /// that number or id.
    std::string id_of(const std::string& written) const;

    /// The number of submissions with this name.
    std::size_t count(const std::string& name) const;

    /// Replaces the names in a map by student with ids. Keeps a name if the map also has its id.
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
