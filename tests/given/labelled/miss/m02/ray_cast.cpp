#include <complex>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iomanip>
#include <iostream>

using std::cout;
typedef std::complex<double> cd;
typedef glm::dvec3 V3;

std::string line(60, '-');
void title(int n) {
    cout << line << "\n Question " << n << " of 10\n" << line << "\n";
}
std::ostream& operator<<(std::ostream& o, const V3& p) {
    return o << "x: " << p.x << "   y: " << p.y << "   z: " << p.z;
}

int main() {
    cout << std::fixed << std::setprecision(9);
    const V3 eye(-2.5, 3, 7), lookat(1, 0.5, -1), vup(0, 1, 0), centre(3, -1, -2);
    const double R = 1.5;
    const V3 A(-4, 0.5, -1), B(3, -1.5, 0.5), C(0.5, 6.5, -2);

    title(1);
    V3 pixel(-1.5 + 3.0 * 200 / 479, -1 + 2.0 * 240 / 319, -2.5);
    cout << " pixel (VCS)    " << pixel << "\n";

    title(2);
    V3 z = normalize(eye - lookat), x = normalize(cross(vup, z)), y = cross(z, x);
    cout << " X              " << x << "\n Y              " << y << "\n Z              " << z << "\n";

    title(3);
    glm::dmat4 m = inverse(glm::lookAt(eye, lookat, vup));
    cout << " VCS to WCS\n";
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) cout << std::setw(15) << m[j][i];
        cout << "\n";
    }

    title(4);
    V3 S(m * glm::dvec4(pixel, 1));
    cout << " pixel (WCS)    " << S << "\n";

    title(5);
    V3 V = normalize(S - eye);
    cout << " ray direction  " << V << "\n";

    title(6);
    double a = dot(V, V), b = 2 * dot(V, S - centre), c = dot(S - centre, S - centre) - R * R, d = b * b - 4 * a * c;
    cout << " a              " << a << "\n b              " << b << "\n c              " << c << "\n d              "
         << d << "\n";
    cd root = std::sqrt(cd(d, 0)), t1 = (-b - root) / (2 * a), t2 = (-b + root) / (2 * a);
    cout << " roots          " << t1 << " and " << t2 << "\n";
    bool real = t1.imag() == 0;
    double t = real ? t1.real() : -1;
    if (real)
        cout << " t              " << t << "\n hit point      " << S + t * V << "\n";
    else
        cout << " t              the roots are complex, there is no real t\n hit point      none, the ray does not hit "
                "the sphere\n";

    title(7);
    if (real)
        cout << " normal         " << normalize(S + t * V - centre) << "\n";
    else
        cout << " normal         none\n";

    title(8);
    glm::dmat3 k(-V, B - A, C - A);
    V3 r = S - A, s = inverse(k) * r;
    cout << " matrix (t, u, v)                                right-hand side\n";
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) cout << std::setw(15) << k[j][i];
        cout << "  " << std::setw(15) << r[i] << "\n";
    }
    cout << " t              " << s[0] << "\n u              " << s[1] << "\n v              " << s[2] << "\n";
    cout << " u + v          " << s[1] + s[2] << "\n hit point      " << S + s[0] * V << "\n";

    title(9);
    cout << " normal         " << normalize(cross(B - A, C - A)) << "\n";

    title(10);
    bool hit = s[0] > 0 && s[1] >= 0 && s[2] >= 0 && s[1] + s[2] <= 1;
    cout << (hit && (!real || s[0] < t) ? " ray hits triangle first\n"
             : real                     ? " ray hits sphere first\n"
                                        : " no hit\n");
}
