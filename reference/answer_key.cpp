#include "reference/answer_key.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "reference/pipeline.h"

namespace reference {
namespace {

std::string_view to_string(PixelConvention convention) {
    switch (convention) {
        case PixelConvention::centre: return "centre";
        case PixelConvention::grid: return "grid";
        case PixelConvention::corner: return "corner";
    }
    return "";
}

/// The values of one run of the stages by question and item name.
using Values = std::map<std::pair<int, std::string_view>, Value>;

/// As a double, and never -0: the key's zeros have no sign.
template <class S>
double plain(const S& x) {
    return static_cast<double>(x) + 0.0;
}

template <class S>
Value number(const S& x) {
    return Numbers{plain(x)};
}

template <class S>
Value vector(const Vec3<S>& p) {
    return Numbers{plain(p.x), plain(p.y), plain(p.z)};
}

template <int N, class S>
Value matrix(const glm::mat<N, N, S>& M) {
    Numbers numbers;
    for (int column = 0; column < N; ++column) {
        for (int row = 0; row < N; ++row) numbers.push_back(plain(M[column][row]));
    }
    return numbers;
}

template <class T, class Convert>
Value present(const std::optional<T>& value, Convert convert) {
    return value ? convert(*value) : Value(NoValue{});
}

template <class S>
struct PipelineRun {
    CameraAnswers<S> camera;
    std::optional<SphereAnswers<S>> sphere;
    std::optional<TriangleAnswers<S>> triangle;
    std::optional<Verdict> verdict;  ///< empty when unsure
};

template <class S>
PipelineRun<S> run_pipeline(const Scene<S>& scene, PixelConvention convention, Boundary boundary) {
    PipelineRun<S> run{answer_camera(scene, convention), {}, {}, {}};
    if (!scene.spheres.empty()) run.sphere = answer_sphere(run.camera, scene.spheres.front(), boundary);
    if (!scene.triangles.empty()) run.triangle = answer_triangle(run.camera, scene.triangles.front());
    const std::optional<S> t_sphere = run.sphere ? run.sphere->t : std::nullopt;
    const std::optional<S> t_triangle = run.triangle ? hit_distance(*run.triangle, boundary) : std::nullopt;
    run.verdict = first_hit(t_sphere, t_triangle);
    return run;
}

template <class S>
Values values_of(const PipelineRun<S>& run, Boundary boundary) {
    Values values;
    const CameraAnswers<S>& camera = run.camera;
    values[{1, "P_VCS"}] = vector(camera.P_VCS);
    values[{2, "X_vcs"}] = vector(camera.basis.X_vcs);
    values[{2, "Y_vcs"}] = vector(camera.basis.Y_vcs);
    values[{2, "Z_vcs"}] = vector(camera.basis.Z_vcs);
    values[{3, "M_VCS_to_WCS"}] = matrix<4>(camera.M_VCS_to_WCS);
    values[{4, "P_WCS"}] = vector(camera.P_WCS);
    values[{5, "V"}] = vector(camera.V);
    if (run.sphere) {
        const Quadratic<S>& quadratic = run.sphere->quadratic;
        values[{6, "a"}] = number(quadratic.a);
        values[{6, "b"}] = number(quadratic.b);
        values[{6, "c"}] = number(quadratic.c);
        values[{6, "d"}] = number(quadratic.d);
        values[{6, "t"}] = present(run.sphere->t, number<S>);
        values[{6, "hit"}] = present(run.sphere->hit, vector<S>);
        values[{7, "normal"}] = present(run.sphere->normal, vector<S>);
    }
    if (run.triangle) {
        const TriangleAnswers<S>& triangle = *run.triangle;
        const bool shown = hit_distance(triangle, boundary).has_value() || triangle.classification != TriangleHit::boundary;
        values[{8, "matrix"}] = matrix<3>(triangle.system.matrix);
        values[{8, "rhs"}] = vector(triangle.system.rhs);
        values[{8, "t"}] = present(triangle.t, number<S>);
        values[{8, "u"}] = present(triangle.u, number<S>);
        values[{8, "v"}] = present(triangle.v, number<S>);
        values[{8, "hit"}] = shown ? present(triangle.hit, vector<S>) : Value(NoValue{});
        values[{9, "normal"}] = vector(triangle.normal);
    }
    if (run.sphere && run.triangle && run.verdict) values[{10, "verdict"}] = *run.verdict;
    return values;
}

std::string sphere_decision(RootChoice choice, std::partial_ordering d) {
    switch (choice) {
        case RootChoice::miss: return "miss";
        case RootChoice::smaller:
        case RootChoice::larger: return d == 0 ? "tangent" : "hit";
        case RootChoice::unsure: return "unsure";
    }
    return "";
}

std::string_view triangle_decision(TriangleHit hit) {
    switch (hit) {
        case TriangleHit::hit: return "hit";
        case TriangleHit::boundary: return "boundary";
        case TriangleHit::miss: return "miss";
        case TriangleHit::parallel: return "parallel";
        case TriangleHit::unsure: return "unsure";
    }
    return "";
}

std::string_view first_decision(std::optional<Verdict> verdict) {
    if (!verdict) return "unsure";
    switch (*verdict) {
        case Verdict::sphere_first: return "sphere";
        case Verdict::triangle_first: return "triangle";
        case Verdict::tie: return "tie";
        case Verdict::no_hit: return "none";
    }
    return "";
}

template <class S>
Decisions decisions_of(const PipelineRun<S>& run) {
    Decisions decisions;
    if (run.sphere) decisions.sphere = sphere_decision(run.sphere->choice, sign_of(run.sphere->quadratic.d));
    if (run.triangle) decisions.triangle = triangle_decision(run.triangle->classification);
    if (run.sphere || run.triangle) decisions.first = first_decision(run.verdict);
    return decisions;
}

bool is_finite(const Value& value) {
    const Numbers* numbers = std::get_if<Numbers>(&value);
    return numbers == nullptr ||
           std::all_of(numbers->begin(), numbers->end(), [](double x) { return std::isfinite(x); });
}

std::vector<Reading> accepted_readings(const Rubric& rubric) {
    std::vector<Reading> readings;
    for (const PixelConvention convention : rubric.pixel_conventions) {
        if (rubric.boundary != BoundaryPolicy::positive) readings.push_back({convention, Boundary::nonnegative});
        if (rubric.boundary != BoundaryPolicy::nonnegative) readings.push_back({convention, Boundary::positive});
    }
    return readings;
}

KeyItem& item_of(AnswerKey& key, const ItemSpec& spec) {
    if (key.questions.empty() || key.questions.back().number < spec.question) key.questions.push_back({spec.question, {}});
    const auto question = std::find_if(key.questions.begin(), key.questions.end(),
                                       [&](const KeyQuestion& q) { return q.number == spec.question; });
    const auto item = std::find_if(question->items.begin(), question->items.end(),
                                   [&](const KeyItem& i) { return i.spec.name == spec.name; });
    return item == question->items.end() ? question->items.emplace_back(KeyItem{spec, {}}) : *item;
}

void add_answers(AnswerKey& key, const Values& values, const Reading& reading) {
    for (const ItemSpec& spec : all_items()) {
        const auto found = values.find({spec.question, spec.name});
        if (found == values.end()) continue;
        if (!is_finite(found->second)) {
            throw std::domain_error(fmt::format("{}: question {}, {} is not a finite number; check the camera and the "
                                                "objects of the scene",
                                                key.assignment, spec.question, spec.name));
        }
        std::vector<Answer>& answers = item_of(key, spec).answers;
        const bool known = std::any_of(answers.begin(), answers.end(),
                                       [&](const Answer& answer) { return answer.value == found->second; });
        if (!known) answers.push_back({found->second, reading});
    }
}

void note_policy(AnswerKey& key) {
    bool boundary = false;
    bool convention = false;
    for (const KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) {
            for (const Answer& answer : item.answers) {
                boundary = boundary || answer.reading.boundary != key.canonical.boundary;
                convention = convention || answer.reading.convention != key.canonical.convention;
            }
        }
    }
    if (boundary) key.decisions.policy.emplace_back("boundary");
    if (convention) key.decisions.policy.emplace_back("pixel convention");
}

template <class S>
AnswerKey make_key_in(const Assignment& assignment, Precision precision) {
    const Scene<S> scene = convert_scene<S>(assignment.scene, [](const Decimal& x) { return scalar_from<S>(x); });
    const std::vector<Reading> readings = accepted_readings(assignment.rubric);
    AnswerKey key{assignment.name, precision, readings.front(), {}, {}};
    for (const Reading& reading : readings) {
        const PipelineRun<S> run = run_pipeline(scene, reading.convention, reading.boundary);
        const Decisions decisions = decisions_of(run);
        for (const std::string& decision : {decisions.sphere, decisions.triangle, decisions.first}) {
            if (decision == "unsure") {
                throw std::domain_error(fmt::format("{}: whether the ray hits can't be decided at {} precision",
                                                    assignment.name, reference::to_string(precision)));
            }
        }
        if (key.questions.empty()) key.decisions = decisions;
        add_answers(key, values_of(run, reading.boundary), reading);
    }
    note_policy(key);
    return key;
}

}  // namespace

std::string_view to_string(Precision precision) {
    switch (precision) {
        case Precision::float_: return "float";
        case Precision::double_: return "double";
    }
    return "";
}

std::string reason(const Answer& answer, const AnswerKey& key) {
    std::string phrase;
    if (answer.reading.convention != key.canonical.convention) {
        phrase = fmt::format("the rubric accepts the {} pixel convention", to_string(answer.reading.convention));
    }
    if (answer.reading.boundary != key.canonical.boundary) {
        phrase += phrase.empty() ? "" : ", and ";
        phrase += "the rubric accepts that t = 0 is not positive and so no hit";
    }
    return phrase;
}

AnswerKey make_key(const Assignment& assignment, Precision precision) {
    switch (precision) {
        case Precision::float_: return make_key_in<float>(assignment, precision);
        case Precision::double_: return make_key_in<double>(assignment, precision);
    }
    throw std::logic_error("make_key: a precision without a scalar");
}

std::string_view sentence(Verdict verdict) {
    switch (verdict) {
        case Verdict::triangle_first: return "ray hits triangle first";
        case Verdict::sphere_first: return "ray hits sphere first";
        case Verdict::tie: return "ray hits sphere and triangle at the same t";
        case Verdict::no_hit: return "ray hits nothing";
    }
    return "";
}

}  // namespace reference
