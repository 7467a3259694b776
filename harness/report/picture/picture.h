// A picture of the assignment: camera, image plane, ray, objects and hit points, by the handout's names.
#pragma once

#include <memory>
#include <string>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// One self-contained <svg> element, for a file or a page. Its ids begin with `id_prefix`, so that a page can hold
/// several. With `graded`, it also shows what that student printed and got wrong. It shows what only the key tells,
/// such as the right hit point, only with `with_answers`. Without, it shows everything that the student printed, and
/// neither its text nor its coordinates give away more of the key. It has no style and no script and loads nothing, so
/// it is safe under any Content-Security-Policy. Its lines and letters take the colour of the surrounding text.
std::string explaining_picture(const Marking& marking, const Graded* graded, bool with_answers,
                               const std::string& id_prefix);

/// The same for a whole class: draws only once what all students' pictures share. Safe to call from several threads.
class ExplainingPictures {
  public:
    ExplainingPictures(const Marking& marking, bool with_answers, const std::string& id_prefix);
    /// Must stand once in the page, before the pictures: an <svg> that takes no room.
    std::string shared_part() const;
    /// One student's picture without the shared part; it shows nothing by itself. `id_prefix` must be unique in the
    /// page.
    std::string picture(const Graded* graded, const std::string& id_prefix) const;
    /// One student's picture, self-contained.
    std::string whole_picture(const Graded* graded, const std::string& id_prefix) const;

  private:
    struct Base;
    std::shared_ptr<const Base> base_;
    std::string id_;  ///< of the shared part
    friend std::string explaining_picture(const Marking&, const Graded*, bool, const std::string&);
};

}  // namespace harness::report
