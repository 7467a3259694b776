#include <iostream>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
using namespace std;
using namespace glm;

const char* ARROW = " ==> ";

ostream& operator<<(ostream& o, vec3 v) { return o << v[0] << "  " << v[1] << "  " << v[2]; }

int main()
{
	// ---- input ----
	vec3 C_s = vec3(1, 1, 0);
	float R_s = 2;
	vec3 tri[3] = { vec3(0, -2, 2), vec3(2, 2, 2), vec3(-2, 2, 2) };
	vec3 eye = vec3(0, 0, 4);
	vec3 lookat = vec3(0, 0, 0);
	vec3 vup = vec3(0, 1, 0);
	float W = 301, H = 201;

	// ---- camera ----
	cout << "-- camera --" << endl;
	vec3 p = vec3(-2 + 4 * (150 / (W - 1)), -1 + 2 * (100 / (H - 1)), -2);
	cout << "P_VCS" << ARROW << p << endl;
	vec3 Z = normalize(eye - lookat);
	vec3 X = normalize(cross(vup, Z));
	vec3 Y = cross(Z, X);
	cout << "X_vcs" << ARROW << X << endl;
	cout << "Y_vcs" << ARROW << Y << endl;
	cout << "Z_vcs" << ARROW << Z << endl;
	mat4 M = inverse(lookAt(eye, lookat, vup));
	cout << "M_VCS_to_WCS" << ARROW << endl;
	for (int r = 0; r < 4; r++)
		cout << "\t" << M[0][r] << "  " << M[1][r] << "  " << M[2][r] << "  " << M[3][r] << endl;
	vec4 pw = M * vec4(p, 1);
	vec3 S = vec3(pw);
	cout << "P_WCS" << ARROW << S << endl;
	vec3 V = normalize(S - eye);
	cout << "V" << ARROW << V << endl;

	// ---- sphere ----
	cout << "-- sphere --" << endl;
	vec3 w = S - C_s;
	float a = dot(V, V);
	float b = 2 * dot(V, w);
	float c = dot(w, w) - R_s * R_s;
	float D = b * b - 4 * a * c;
	cout << "a" << ARROW << a << endl;
	cout << "b" << ARROW << b << endl;
	cout << "c" << ARROW << c << endl;
	cout << "d" << ARROW << D << endl;
	float t_s = (-b - sqrt(D)) / 2 / a;
	vec3 P_s = S + t_s * V;
	vec3 N_s = normalize(P_s - C_s);
	cout << "t" << ARROW << t_s << endl;
	cout << "P_s" << ARROW << P_s << endl;
	cout << "N" << ARROW << N_s << endl;

	// ---- triangle ----
	cout << "-- triangle --" << endl;
	vec3 E1 = tri[1] - tri[0];
	vec3 E2 = tri[2] - tri[0];
	mat3 A = mat3(-V, E1, E2);
	vec3 rhs = S - tri[0];
	vec3 tuv = inverse(A) * rhs;
	cout << "A" << ARROW << endl;
	for (int r = 0; r < 3; r++)
		cout << "\t" << A[0][r] << "  " << A[1][r] << "  " << A[2][r] << endl;
	cout << "right-hand side" << ARROW << rhs << endl;
	cout << "t" << ARROW << tuv[0] << endl;
	cout << "u" << ARROW << tuv[1] << endl;
	cout << "v" << ARROW << tuv[2] << endl;
	vec3 P_t = tri[0] + tuv[1] * E1 + tuv[2] * E2;
	vec3 N_t = normalize(cross(E1, E2));
	cout << "P_t" << ARROW << P_t << endl;
	cout << "N" << ARROW << N_t << endl;

	// ---- result ----
	cout << "-- result --" << endl;
	bool ok = tuv[0] > 0 && tuv[1] >= 0 && tuv[1] <= 1 && tuv[2] >= 0 && tuv[2] <= 1 && tuv[1] + tuv[2] <= 1;
	cout << "true hit of triangle (t > 0)" << ARROW << (ok ? "yes" : "no") << endl;
	cout << "first" << ARROW << (ok && tuv[0] < t_s ? "ray hits triangle first" : "ray hits sphere first") << endl;
	return 0;
}
