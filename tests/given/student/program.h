// The answers a student's program computes in float: right in one of several ways, or with one wrong stage whose result
// the later stages use.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <vector>

#include "reference/stages/camera.h"
#include "reference/stages/first_hit.h"
#include "reference/stages/items.h"
#include "reference/stages/quadratic.h"
#include "reference/toml/assignment.h"

namespace student {

using reference::ItemId;
using Floats = std::vector<float>;

/// How a program computes its right answers.
struct Way {
    /// `stages`: the reference's stages in float. `glm`: GLM's own functions lookAt, inverse and normalize, and the
    /// inverse of the linear system.
    enum class Arithmetic { stages, glm, glm_cramer } arithmetic = Arithmetic::stages;
    reference::PixelConvention convention = reference::PixelConvention::centre;
    reference::Boundary boundary = reference::Boundary::nonnegative;
    float quadratic_factor = 1;                  ///< the sphere's and the cylinder's a, b and c are multiplied by this
    std::vector<float> row_factors = {1, 1, 1};  ///< the rows of the linear system are multiplied by these, both sides
    bool half_b = false;                         ///< b' = b/2 and d' = b'^2 - ac, of the sphere and of the cylinder
    std::vector<int> columns = {0, 1, 2};        ///< the places of the columns for t, u and v in the printed matrix
    bool true_hits_only = false;                 ///< gives a hit point only for a true hit
};

/// The answers computed so far. A value that does not exist, because the ray misses, is an empty optional.
class Program {
  public:
    /// One wrong stage: computes the program's wrong value for `item`.
    struct Mistake {
        ItemId item;
        /// Gets the answers so far, and the value that would be right given those answers.
        std::function<std::optional<Floats>(const Program&, const std::optional<Floats>& right)> compute;
    };

    Program(const reference::Assignment& assignment, const Way& way, std::optional<Mistake> mistake = {});

    const std::map<ItemId, std::optional<Floats>>& values() const { return values_; }
    reference::FirstObject first_object() const { return first_object_; }
    const reference::Scene<float>& scene() const { return scene_; }
    const std::vector<reference::Question>& questions() const { return questions_; }
    /// The items of the assignment's questions whose object is in the scene.
    const std::vector<reference::ItemSpec>& asked() const { return asked_; }

    /// scalar, vector and matrix4 throw std::bad_optional_access if the value does not exist.
    float scalar(const ItemId& id) const { return values_.at(id).value().at(0); }
    glm::vec3 vector(const ItemId& id) const;
    glm::mat4 matrix4(const ItemId& id) const;
    bool has(const ItemId& id) const { return values_.contains(id) && values_.at(id).has_value(); }

  private:
    void settle(const ItemId& id, std::optional<Floats> value);
    void answer_camera();
    void answer_sphere();
    void answer_triangle();
    void solve_triangle(const glm::vec3& rhs);
    void answer_cylinder();
    void solve_tube(const glm::vec2& start, const glm::vec2& direction);
    std::optional<float> tube_hit() const;
    std::optional<float> cap_hit(float y) const;
    glm::vec3 cylinder_normal(std::optional<float> up) const;
    void compare_hits();
    bool in_triangle() const;
    bool is_hit_at(float t) const;
    bool uses_glm() const { return way_.arithmetic != Way::Arithmetic::stages; }

    reference::Scene<float> scene_;
    std::vector<reference::Question> questions_;
    std::vector<reference::ItemSpec> asked_;
    Way way_;
    std::optional<Mistake> mistake_;
    std::map<ItemId, std::optional<Floats>> values_;
    reference::FirstObject first_object_ = reference::FirstObject::no_hit;
};

Floats floats(float x);
Floats floats(const glm::vec3& p);
Floats floats(const glm::mat3& m);
Floats floats(const glm::mat4& m);

}  // namespace student
