// A correct program, as a student writes it, compiled under the flags of its target: reads scenes and choices of
// formulas, prints the ten answers to each.
//
// Input, one program after the other: the formulas' numbers, the scalar's and the printing's, then the scene's numbers:
// eye, lookat, vup, left, right, bottom, top, near, W, H, x, y, center, radius, A, B, C. After each printout comes a
// line with one character 1.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <type_traits>

#include "tests/harness/mark/correct_programs/formulas.h"
#ifdef DRAWN_ROUNDINGS
#include "tests/harness/mark/correct_programs/drawn.h"
#endif

namespace {

// Of numbers that are not built in, their own.
using std::abs;
using std::pow;
using std::sqrt;

/// Variables are S, constants such as 2.0 are L.
template <class S, class L>
class Program {
  public:
    Program(const correct::Formulas& formulas, int printing, std::istream& input);
    std::string run();

  private:
    using V3 = glm::vec<3, S>;
    using M3 = glm::mat<3, 3, S>;
    using M4 = glm::mat<4, 4, S>;

    S number() {
        std::string text;
        input_ >> text;
        if constexpr (std::is_same_v<S, float> || std::is_class_v<S>) return S(std::strtof(text.c_str(), nullptr));
        if constexpr (std::is_same_v<S, double>) return std::strtod(text.c_str(), nullptr);
        if constexpr (std::is_same_v<S, long double>) return std::strtold(text.c_str(), nullptr);
    }
    V3 point() {
        const S x = number(), y = number(), z = number();
        return V3(x, y, z);
    }
    static S c(double x) { return static_cast<S>(x); }
    int formula(std::size_t stage) const { return formulas_[stage]; }

    S window(S l, S r, S i, S n) const;
    void axes();
    void matrix();
    void ray();
    void sphere();
    S roots(S& far) const;
    void triangle();
    V3 solve() const;
    static V3 eliminate(M3 m, V3 right, bool pivots, bool jordan);
    V3 by_plane(bool by_dots) const;
    V3 triangle_normal() const;

    std::string text(S x) const;
    std::string text(const V3& p) const { return "(" + text(p.x) + ", " + text(p.y) + ", " + text(p.z) + ")"; }
    template <class M>
    void print_rows(const char* label, const M& m, int n);
    template <class T>
    void print(const char* label, const T& value) {
        out_ << label << ": " << text(value) << "\n";
    }

    correct::Formulas formulas_;
    int printing_;
    std::istream& input_;
    std::ostringstream out_;
    V3 eye, lookat, vup, C, T0, T1, T2;
    S l, r, b, t, near, W, H, px, py, R;
    V3 p, X, Y, Z, P, V;
    M4 M;
    S qa, qb, qc, qd, ts;
    bool hits_sphere = false;
    V3 e1, e2, rhs;
};

template <class S, class L>
Program<S, L>::Program(const correct::Formulas& formulas, int printing, std::istream& input)
    : formulas_(formulas), printing_(printing), input_(input) {
    eye = point();
    lookat = point();
    vup = point();
    l = number(), r = number(), b = number(), t = number(), near = number();
    W = number(), H = number(), px = number(), py = number();
    C = point();
    R = number();
    T0 = point(), T1 = point(), T2 = point();
}

template <class S, class L>
S Program<S, L>::window(S from, S to, S i, S n) const {
    const S step = (to - from) / n;
    const S s = (i + L(0.5)) / n;
    const S device = L(2) * (i + L(0.5)) / n - L(1);
    switch (formula(0)) {
        case 0: return from + (to - from) * (i + L(0.5)) / n;
        case 1: return from + (i + L(0.5)) * step;
        case 2: return from + step / L(2) + i * step;
        case 3: return from * (L(1) - s) + to * s;
        default: return device * (to - from) / L(2) + (to + from) / L(2);
    }
}

template <class S, class L>
void Program<S, L>::axes() {
    const V3 n = eye - lookat;
    Z = glm::normalize(n);
    switch (formula(1)) {
        case 0:
            X = glm::normalize(glm::cross(vup, Z));
            Y = glm::cross(Z, X);
            break;
        case 1:
            X = glm::normalize(glm::cross(vup, Z));
            Y = glm::normalize(glm::cross(Z, X));
            break;
        case 2: {
            const M4 view = glm::lookAt(eye, lookat, vup);
            X = V3(view[0][0], view[1][0], view[2][0]);
            Y = V3(view[0][1], view[1][1], view[2][1]);
            Z = V3(view[0][2], view[1][2], view[2][2]);
            break;
        }
        case 3:
            X = glm::normalize(glm::cross(glm::normalize(vup), Z));
            Y = glm::cross(Z, X);
            break;
        case 4: {
            const V3 forward = glm::normalize(lookat - eye);
            X = glm::normalize(glm::cross(forward, vup));
            Y = glm::cross(X, forward);
            Z = -forward;
            break;
        }
        case 5: {
            const V3 right = glm::cross(vup, n);
            X = glm::normalize(right);
            Y = glm::normalize(glm::cross(n, right));
            break;
        }
        case 6:
            Y = glm::normalize(vup - glm::dot(vup, Z) * Z);
            X = glm::cross(Y, Z);
            break;
        default: {
            Z = n / sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
            const V3 right(vup.y * Z.z - vup.z * Z.y, vup.z * Z.x - vup.x * Z.z, vup.x * Z.y - vup.y * Z.x);
            X = right / sqrt(right.x * right.x + right.y * right.y + right.z * right.z);
            Y = glm::cross(Z, X);
        }
    }
}

template <class S, class L>
void Program<S, L>::matrix() {
    using V4 = glm::vec<4, S>;
    const S zero = c(0), one = c(1);
    const M4 columns(V4(X, zero), V4(Y, zero), V4(Z, zero), V4(eye, one));
    const M4 rows(V4(X.x, Y.x, Z.x, zero), V4(X.y, Y.y, Z.y, zero), V4(X.z, Y.z, Z.z, zero),
                  V4(-glm::dot(X, eye), -glm::dot(Y, eye), -glm::dot(Z, eye), one));
    switch (formula(2)) {
        case 0: M = columns; break;
        case 1: M = glm::inverse(rows); break;
        case 2: M = glm::inverse(glm::lookAt(eye, lookat, vup)); break;
        case 3: M = glm::translate(M4(one), eye) * M4(V4(X, zero), V4(Y, zero), V4(Z, zero), V4(V3(zero), one)); break;
        case 4: {
            const V3 moved(rows[3]);
            M = M4(V4(X, zero), V4(Y, zero), V4(Z, zero), V4(-(M3(X, Y, Z) * moved), one));
            break;
        }
        default: {
            const M4 rotation = glm::transpose(M4(V4(X, zero), V4(Y, zero), V4(Z, zero), V4(V3(zero), one)));
            M = glm::inverse(rotation * glm::translate(M4(one), -eye));
        }
    }
}

template <class S, class L>
void Program<S, L>::ray() {
    using V4 = glm::vec<4, S>;
    const V4 point = M * V4(p, c(1));
    const V3 step = p.x * X + p.y * Y + p.z * Z;
    const auto row = [&](int i) { return M[0][i] * p.x + M[1][i] * p.y + M[2][i] * p.z + M[3][i]; };
    switch (formula(3)) {
        case 0: P = V3(point); break;
        case 1: P = eye + p.x * X + p.y * Y - near * Z; break;
        case 2: P = V3(row(0), row(1), row(2)); break;
        default: P = V3(point) / point.w;
    }
    const V3 from_eye = P - eye;
    switch (formula(4)) {
        case 0: V = glm::normalize(from_eye); break;
        case 1: V = glm::normalize(step); break;
        case 2: V = V3(M * V4(glm::normalize(p), c(0))); break;
        default: V = from_eye / sqrt(glm::dot(from_eye, from_eye));
    }
}

template <class S, class L>
S Program<S, L>::roots(S& far) const {
    const V3 to_center = C - P;
    const S tca = glm::dot(to_center, V);
    const S root = sqrt(qd);
    const S half = qb / L(2);
    const S half_root = sqrt(half * half - qa * qc);
    const S q = L(-0.5) * (qb + (qb < c(0) ? -root : root));
    const S thc = sqrt(R * R - (glm::dot(to_center, to_center) - tca * tca));
    const V3 nearest = to_center - tca * V;
    const S reach = sqrt(R * R - glm::dot(nearest, nearest));
    S close{};
    switch (formula(6)) {
        case 0: close = (-qb - root) / (L(2) * qa), far = (-qb + root) / (L(2) * qa); break;
        case 1: close = (-half - half_root) / qa, far = (-half + half_root) / qa; break;
        case 2: close = std::min<S>(q / qa, qc / q), far = std::max<S>(q / qa, qc / q); break;
        case 3: close = tca - thc, far = tca + thc; break;
        case 4: close = -qb / (L(2) * qa) - root / (L(2) * qa), far = -qb / (L(2) * qa) + root / (L(2) * qa); break;
        case 5: close = tca - reach, far = tca + reach; break;
        default: close = (-qb - root) / L(2), far = (-qb + root) / L(2);
    }
    return close;
}

template <class S, class L>
void Program<S, L>::sphere() {
    const V3 from = P - C;
    const S distance = glm::length(from);
    qa = formula(5) == 5 ? c(1) : glm::dot(V, V);
    qb = L(2) * glm::dot(V, from);
    qc = glm::dot(from, from) - R * R;
    if (formula(5) == 1) {
        qb = L(2) * V.x * from.x + L(2) * V.y * from.y + L(2) * V.z * from.z;
        qc = pow(from.x, L(2)) + pow(from.y, L(2)) + pow(from.z, L(2)) - pow(R, L(2));
    }
    if (formula(5) == 2) qc = glm::dot(P, P) - L(2) * glm::dot(P, C) + glm::dot(C, C) - R * R;
    if (formula(5) == 3) qc = distance * distance - R * R;
    if (formula(5) == 4) qc = (distance - R) * (distance + R);
    qd = formula(6) == 1 ? L(4) * ((qb / L(2)) * (qb / L(2)) - qa * qc) : qb * qb - L(4) * qa * qc;
    if (!(qd >= c(0))) return;
    S far{};
    const S close = roots(far);
    ts = close > c(0) ? close : far;
    hits_sphere = ts > c(0);
}

template <class S, class L>
typename Program<S, L>::V3 Program<S, L>::eliminate(M3 m, V3 right, bool pivots, bool jordan) {
    // a[row][column], the right-hand side in column 3
    S a[3][4];
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) a[i][j] = m[j][i];
        a[i][3] = right[i];
    }
    for (int k = 0; k < 3; ++k) {
        int best = k;
        for (int i = k + 1; i < 3; ++i) {
            const bool better = abs(a[i][k]) > (pivots ? c(1) : c(64)) * abs(a[best][k]);
            if (better) best = i;
        }
        for (int j = 0; j < 4; ++j) std::swap(a[k][j], a[best][j]);
        if (jordan) {
            const S pivot = a[k][k];
            for (int j = 0; j < 4; ++j) a[k][j] /= pivot;
        }
        for (int i = jordan ? 0 : k + 1; i < 3; ++i) {
            if (i == k) continue;
            const S factor = a[i][k] / a[k][k];
            for (int j = 0; j < 4; ++j) a[i][j] -= factor * a[k][j];
        }
    }
    if (jordan) return V3(a[0][3], a[1][3], a[2][3]);
    const S z = a[2][3] / a[2][2];
    const S y = (a[1][3] - a[1][2] * z) / a[1][1];
    const S x = (a[0][3] - a[0][1] * y - a[0][2] * z) / a[0][0];
    return V3(x, y, z);
}

template <class S, class L>
typename Program<S, L>::V3 Program<S, L>::by_plane(bool by_dots) const {
    const V3 N = glm::cross(e1, e2);
    const S distance = glm::dot(N, T0 - P) / glm::dot(N, V);
    const V3 w = P + distance * V - T0;
    if (!by_dots) {
        const S square = glm::dot(N, N);
        return V3(distance, glm::dot(glm::cross(w, e2), N) / square, glm::dot(glm::cross(e1, w), N) / square);
    }
    const S d00 = glm::dot(e1, e1), d01 = glm::dot(e1, e2), d11 = glm::dot(e2, e2);
    const S d20 = glm::dot(w, e1), d21 = glm::dot(w, e2);
    const S denominator = d00 * d11 - d01 * d01;
    return V3(distance, (d11 * d20 - d01 * d21) / denominator, (d00 * d21 - d01 * d20) / denominator);
}

template <class S, class L>
typename Program<S, L>::V3 Program<S, L>::solve() const {
    const M3 m(-V, e1, e2);
    switch (formula(8)) {
        case 0: {
            const V3 n = glm::cross(e1, e2), q = glm::cross(-V, rhs);
            const S det = glm::dot(-V, n);
            return V3(glm::dot(rhs, n) / det, glm::dot(q, e2) / det, -glm::dot(q, e1) / det);
        }
        case 1: return glm::inverse(m) * rhs;
        case 2: {
            const S det = glm::determinant(m);
            return V3(glm::determinant(M3(rhs, e1, e2)) / det, glm::determinant(M3(-V, rhs, e2)) / det,
                      glm::determinant(M3(-V, e1, rhs)) / det);
        }
        case 3: {
            const V3 h = glm::cross(V, e2), q = glm::cross(rhs, e1);
            const S f = L(1) / glm::dot(e1, h);
            return V3(f * glm::dot(e2, q), f * glm::dot(rhs, h), f * glm::dot(V, q));
        }
        case 4: return eliminate(m, rhs, false, false);
        case 5: return eliminate(m, rhs, true, false);
        case 6: return eliminate(m, rhs, true, true);
        case 7: return by_plane(true);
        default: return by_plane(false);
    }
}

template <class S, class L>
typename Program<S, L>::V3 Program<S, L>::triangle_normal() const {
    switch (formula(10)) {
        case 0: return glm::normalize(glm::cross(e1, e2));
        case 1: return glm::normalize(glm::cross(glm::normalize(e1), glm::normalize(e2)));
        case 2: return glm::normalize(-glm::cross(e2, e1));
        default: return glm::normalize(glm::cross(T1 - T0, T2 - T1));
    }
}

template <class S, class L>
std::string Program<S, L>::text(S x) const {
    std::ostringstream text;
    if (printing_ == 0) text << std::fixed << std::setprecision(6);
    if (printing_ == 2) text << std::setprecision(9);
    text << x;
    return text.str();
}

template <class S, class L>
template <class Matrix>
void Program<S, L>::print_rows(const char* label, const Matrix& m, int n) {
    out_ << label << ":\n";
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) out_ << (j > 0 ? " " : "") << text(m[j][i]);
        out_ << "\n";
    }
}

template <class S, class L>
std::string Program<S, L>::run() {
    p = V3(window(l, r, px, W), window(b, t, py, H), -near);
    axes();
    matrix();
    ray();
    sphere();
    e1 = T1 - T0, e2 = T2 - T0, rhs = P - T0;
    const V3 solution = solve();
    const S tt = solution.x, u = solution.y, v = solution.z;

    out_ << "Question 1:\n";
    print("P_VCS", p);
    out_ << "Question 2:\n";
    print("X_vcs", X), print("Y_vcs", Y), print("Z_vcs", Z);
    out_ << "Question 3:\n";
    print_rows("M_VCS_to_WCS", M, 4);
    out_ << "Question 4:\n";
    print("P_WCS", P);
    out_ << "Question 5:\n";
    print("V", V);
    out_ << "Question 6:\n";
    print("a", qa), print("b", qb), print("c", qc), print("d", qd);
    const V3 hit = P + ts * V;
    if (hits_sphere) {
        print("t", ts), print("hit point", hit);
        out_ << "Question 7:\n";
        print("normal", formula(7) == 0   ? glm::normalize(hit - C)
                        : formula(7) == 1 ? (hit - C) / R
                                          : (hit - C) / glm::length(hit - C));
    } else {
        out_ << "t: none\nhit point: none\nQuestion 7:\nnormal: none\n";
    }
    out_ << "Question 8:\n";
    print_rows("matrix", M3(-V, e1, e2), 3);
    print("right-hand side", rhs), print("t", tt), print("u", u), print("v", v);
    print("hit point", formula(9) == 0   ? P + tt * V
                       : formula(9) == 1 ? T0 + u * e1 + v * e2
                                         : (c(1) - u - v) * T0 + u * T1 + v * T2);
    out_ << "Question 9:\n";
    print("normal", triangle_normal());
    out_ << "Question 10:\n";
    const bool hits_triangle = tt > c(0) && u >= c(0) && v >= c(0) && u + v <= c(1);
    if (hits_triangle && (!hits_sphere || tt < ts)) {
        out_ << "ray hits triangle first\n";
    } else if (hits_sphere) {
        out_ << "ray hits sphere first\n";
    } else {
        out_ << "ray hits nothing\n";
    }
    return out_.str();
}

}  // namespace

int main() {
    correct::Formulas formulas{};
    while (std::cin >> formulas[0]) {
        for (std::size_t i = 1; i < formulas.size(); ++i) std::cin >> formulas[i];
        int scalar = 0, printing = 0;
        std::cin >> scalar >> printing;
        std::string printout;
#ifdef DRAWN_ROUNDINGS
        correct::Drawn::begin(correct::Drawn::draw_bit() && correct::Drawn::draw_bit());
        printout = Program<correct::Drawn, correct::Drawn>(formulas, printing, std::cin).run();
#else
        if (scalar == 0) printout = Program<float, float>(formulas, printing, std::cin).run();
        if (scalar == 1) printout = Program<float, double>(formulas, printing, std::cin).run();
        if (scalar == 2) printout = Program<double, double>(formulas, printing, std::cin).run();
        if (scalar == 3) printout = Program<long double, long double>(formulas, printing, std::cin).run();
#endif
        std::cout << printout << "\x01\n";
    }
}
