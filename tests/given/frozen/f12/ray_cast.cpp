#include <cmath>
#include <iomanip>
#include <iostream>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

using namespace std;

class RayCaster
{
public:
    void run();

private:
    void line(const string &label, const glm::vec3 &v) const
    {
        cout << "    " << left << setw(14) << label << right << setw(12) << v.x << setw(12) << v.y << setw(12) << v.z << '\n';
    }
    void line(const string &label, float f) const
    {
        cout << "    " << left << setw(14) << label << right << setw(12) << f << '\n';
    }
    template <typename M> void rows(const string &label, const M &m, int n) const
    {
        cout << "    " << label << '\n';
        for (int r = 0; r < n; ++r)
        {
            for (int c = 0; c < n; ++c)
                cout << setw(12) << m[c][r];
            cout << '\n';
        }
    }

    glm::vec3 center{1, 1, 0};
    float radius = 2;
    glm::vec3 A{0, -2, 2}, B{2, 2, 2}, C{-2, 2, 2};
    glm::vec3 eye{0, 0, 4}, lookat{0, 0, 0}, vup{0, 1, 0};
    float W = 301, H = 201;
};

void RayCaster::run()
{
    cout << fixed << setprecision(6);
    cout << "Step 1:\n";
    glm::vec3 vcs(-2 + 4 * 150 / W, -1 + 2 * 100 / H, -2);
    line("P_VCS", vcs);

    cout << "Step 2:\n";
    glm::vec3 z = glm::normalize(eye - lookat);
    glm::vec3 x = glm::normalize(glm::cross(vup, z));
    glm::vec3 y = glm::cross(z, x);
    line("X_vcs", x);
    line("Y_vcs", y);
    line("Z_vcs", z);

    cout << "Step 3:\n";
    glm::mat4 m = glm::inverse(glm::lookAt(eye, lookat, vup));
    rows("M_VCS_to_WCS", m, 4);

    cout << "Step 4:\n";
    glm::vec3 S(m * glm::vec4(vcs, 1));
    line("P_WCS", S);

    cout << "Step 5:\n";
    glm::vec3 V = glm::normalize(S - eye);
    line("V", V);

    cout << "Step 6:\n";
    glm::vec3 k = S - center;
    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, k);
    float c = glm::dot(k, k) - radius * radius;
    float d = b * b - 4 * a * c;
    float t = (-b - sqrt(d)) / (2 * a);
    glm::vec3 Ps = S + t * V;
    line("a", a);
    line("b", b);
    line("c", c);
    line("d", d);
    line("t", t);
    line("P_s", Ps);

    cout << "Step 7:\n";
    line("normal", glm::normalize(Ps - center));

    cout << "Step 8:\n";
    glm::mat3 eq(-V, B - A, C - A);
    glm::vec3 sol = glm::inverse(eq) * (S - A);
    rows("matrix", eq, 3);
    line("rhs", S - A);
    line("t", sol.x);
    line("u", sol.y);
    line("v", sol.z);
    line("P_t", S + sol.x * V);

    cout << "Step 9:\n";
    line("normal", glm::normalize(glm::cross(B - A, C - A)));

    cout << "Step 10:\n";
    cout << "    ray hits " << (sol.x < t ? "triangle" : "sphere") << " first\n";
}

int main()
{
    RayCaster().run();
}
