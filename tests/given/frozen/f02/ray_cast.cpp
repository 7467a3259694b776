#include <iostream>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
using namespace std;
using namespace glm;

int main()
{
	vec3 C(1, 1, 0);
	float R = 2;
	vec3 triA(0, -2, 2), triB(2, 2, 2), triC(-2, 2, 2);
	vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
	float clipLeft = -2, clipRight = 2, clipBottom = -1, clipTop = 1, clipNear = 2;
	int W = 301, H = 201;
	int px = 150, py = 100;

	vec3 p;
	p.x = clipLeft + px * (clipRight - clipLeft) / (W - 1);
	p.y = clipBottom + py * (clipTop - clipBottom) / (H - 1);
	p.z = -clipNear;
	cout << "Q1: " << p.x << ' ' << p.y << ' ' << p.z << endl;

	vec3 n = normalize(eye - lookat);
	vec3 u = normalize(cross(vup, n));
	vec3 v = cross(n, u);
	cout << "Q2: X_vcs = " << u.x << ' ' << u.y << ' ' << u.z << endl;
	cout << "    Y_vcs = " << v.x << ' ' << v.y << ' ' << v.z << endl;
	cout << "    Z_vcs = " << n.x << ' ' << n.y << ' ' << n.z << endl;

	mat4 M = inverse(lookAt(eye, lookat, vup));
	cout << "Q3: M_VCS_to_WCS =" << endl;
	for (int row = 0; row < 4; row++) {
		cout << "   ";
		for (int col = 0; col < 4; col++)
			cout << ' ' << M[col][row];
		cout << endl;
	}

	vec4 w = M * vec4(p, 1);
	cout << "Q4: " << w.x << ' ' << w.y << ' ' << w.z << endl;

	vec3 S(w);
	vec3 V = normalize(S - eye);
	cout << "Q5: " << V.x << ' ' << V.y << ' ' << V.z << endl;

	float a = dot(V, V);
	float b = 2 * dot(V, S - C);
	float c = dot(S - C, S - C) - R * R;
	float d = b * b - 4 * a * c;
	float ts = -1;
	float r1 = (-b - sqrt(d)) / (2 * a), r2 = (-b + sqrt(d)) / (2 * a);
	if (r1 > 0 && r2 > 0) ts = glm::min(r1, r2);
	else if (r1 > 0) ts = r1;
	else if (r2 > 0) ts = r2;
	vec3 hs = S + ts * V;
	cout << "Q6: a = " << a << endl;
	cout << "    b = " << b << endl;
	cout << "    c = " << c << endl;
	cout << "    d = " << d << endl;
	cout << "    t = " << ts << endl;
	cout << "    P_s = " << hs.x << ' ' << hs.y << ' ' << hs.z << endl;

	vec3 ns = normalize(hs - C);
	cout << "Q7: " << ns.x << ' ' << ns.y << ' ' << ns.z << endl;

	// u(B-A) + v(C-A) - tV = S - A, unknowns in the order u, v, t
	mat3 A(triB - triA, triC - triA, -V);
	vec3 rhs = S - triA;
	vec3 sol = inverse(A) * rhs;
	vec3 ht = S + sol.z * V;
	cout << "Q8: A (unknowns are u, v, t) =" << endl;
	for (int row = 0; row < 3; row++)
		cout << "    " << A[0][row] << ' ' << A[1][row] << ' ' << A[2][row] << endl;
	cout << "    rhs = " << rhs.x << ' ' << rhs.y << ' ' << rhs.z << endl;
	cout << "    t = " << sol.z << endl;
	cout << "    u = " << sol.x << endl;
	cout << "    v = " << sol.y << endl;
	cout << "    P_t = " << ht.x << ' ' << ht.y << ' ' << ht.z << endl;

	vec3 nt = normalize(cross(triB - triA, triC - triA));
	cout << "Q9: " << nt.x << ' ' << nt.y << ' ' << nt.z << endl;

	bool trueHit = sol.z > 0 && sol.x >= 0 && sol.y >= 0 && sol.x + sol.y <= 1;
	if (trueHit && sol.z < ts)
		cout << "Q10: ray hits triangle first" << endl;
	else
		cout << "Q10: ray hits sphere first" << endl;
	return 0;
}
