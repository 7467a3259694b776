#include "harness/class_run/students/student_names.h"

#include "harness/text/encoding.h"

namespace harness {

void StudentNames::add(const Submission& submission) {
    ids_.insert(submission.id);
    if (submission.lms) numbers_.insert(submission.lms->id);
    ids_by_name_.emplace(composed_name(label_of(submission)), submission.id);
}

std::string StudentNames::id_of(const std::string& written) const {
    const std::string called = composed_name(written);
    if (ids_.contains(called) || numbers_.contains(called) || count(called) != 1) return called;
    return ids_by_name_.find(called)->second;
}

std::size_t StudentNames::count(const std::string& name) const {
    return ids_by_name_.count(composed_name(name));
}

}  // namespace harness
