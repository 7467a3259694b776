// A picture of the assignment: camera, image plane, ray, objects and hit points, by the handout's names.
#pragma once

#include <memory>
#include <string>

#include "harness/grade.h"

namespace harness::report {

/// One self-contained <svg> element, to be a file or to be put into a page; ids in it begin with `id_prefix`, so that
/// several fit one page. With `graded`, what that student printed and got wrong is drawn too. What the key alone tells,
/// such as the right hit point, is drawn only where `with_answers`: without, all that the student printed is drawn, and
/// neither text nor coordinates hold more of the key than that. No style, no script, nothing loaded: it is safe under
/// any Content-Security-Policy. Its lines and letters have the colour of the text around it.
std::string explaining_picture(const Marking& marking, const Graded* graded, bool with_answers,
                               const std::string& id_prefix);

/// The same for many students of one class: what is the same for all is drawn once.
class ExplainingPictures {
  public:
    ExplainingPictures(const Marking& marking, bool with_answers, const std::string& id_prefix);
    ~ExplainingPictures();
    ExplainingPictures(ExplainingPictures&&) noexcept;
    ExplainingPictures& operator=(ExplainingPictures&&) noexcept;

    /// To stand once in the page that holds the pictures, before them: an <svg> that takes no room.
    std::string shared_part() const;
    /// One student's, without the shared part; it shows nothing by itself. Its own prefix, unlike all others in the
    /// page. Safe to call from several threads at a time.
    std::string picture(const Graded* graded, const std::string& id_prefix) const;
    /// One student's, self-contained.
    std::string whole_picture(const Graded* graded, const std::string& id_prefix) const;

  private:
    struct Base;
    struct Drawings;
    std::unique_ptr<const Base> base_;
    std::unique_ptr<Drawings> drawings_;  ///< of students who printed the same
    std::string id_;                      ///< of the shared part
    friend std::string explaining_picture(const Marking&, const Graded*, bool, const std::string&);
};

}  // namespace harness::report
