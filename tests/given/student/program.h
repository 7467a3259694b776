// What a student's program computes, in float: right in one of several ways, or with one stage changed and carried on.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <vector>

#include "reference/answer_key.h"

namespace student {

using reference::ItemId;
using Floats = std::vector<float>;

/// How a program computes what it computes rightly.
struct Way {
    /// The stages of the reference over float; or GLM's own functions: lookAt and inverse, normalize, the inverse of
    /// the system.
    enum class Arithmetic { stages, glm, glm_cramer } arithmetic = Arithmetic::stages;
    reference::PixelConvention convention = reference::PixelConvention::centre;
    reference::Boundary boundary = reference::Boundary::nonnegative;
    float quadratic_factor = 1;                  ///< a, b and c are multiplied by this
    std::vector<float> row_factors = {1, 1, 1};  ///< the rows of the linear system, on both sides
    bool half_b = false;                         ///< b' = b/2 and d' = b'^2 - ac
    std::vector<int> columns = {0, 1, 2};        ///< the place of the columns for t, u and v in the printed matrix
    bool true_hits_only = false;                 ///< no hit point where there is no true hit
};

/// The answers so far. A value that does not exist (the ray misses) is an empty optional.
class Program {
  public:
    /// One stage done wrongly: what the program has for `item` instead.
    struct Mistake {
        ItemId item;
        /// From the answers so far and what is right with them.
        std::function<std::optional<Floats>(const Program&, const std::optional<Floats>& right)> compute;
    };

    Program(const reference::Assignment& assignment, const Way& way, std::optional<Mistake> mistake = {});

    const std::map<ItemId, std::optional<Floats>>& values() const { return values_; }
    reference::Verdict verdict() const { return verdict_; }
    const reference::Scene<float>& scene() const { return scene_; }

    /// These throw std::bad_optional_access where there is no such value.
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
    bool in_triangle() const;
    bool is_hit_at(float t) const;
    bool uses_glm() const { return way_.arithmetic != Way::Arithmetic::stages; }

    reference::Scene<float> scene_;
    Way way_;
    std::optional<Mistake> mistake_;
    std::map<ItemId, std::optional<Floats>> values_;
    reference::Verdict verdict_ = reference::Verdict::no_hit;
};

Floats floats(float x);
Floats floats(const glm::vec3& p);
Floats floats(const glm::mat3& m);
Floats floats(const glm::mat4& m);

}  // namespace student
