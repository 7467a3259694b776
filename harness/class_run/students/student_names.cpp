#include "harness/class_run/students/student_names.h"

namespace harness {

void StudentNames::add(const Submission& submission) {
    ids_.insert(submission.id);
    if (submission.lms) numbers_.insert(submission.lms->id);
    ids_by_name_.emplace(label_of(submission), submission.id);
}

std::string StudentNames::id_of(const std::string& called) const {
    if (ids_.contains(called) || numbers_.contains(called) || count(called) != 1) return called;
    return ids_by_name_.find(called)->second;
}

std::size_t StudentNames::count(const std::string& name) const {
    return ids_by_name_.count(name);
}

}  // namespace harness
