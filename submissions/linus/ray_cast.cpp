/* CS 870 assignment 6 */
#include <math.h>
#include <stdio.h>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/matrix_access.hpp>

#define SHOW3(name, v) printf("  " name ": %.3f %.3f %.3f\n", (v).x, (v).y, (v).z)

static void rows4(const glm::mat4 &m)
{
	int i;
	for (i = 0; i < 4; i++) {
		glm::vec4 r = glm::row(m, i);
		printf("  | %7.3f %7.3f %7.3f %7.3f |\n", r.x, r.y, r.z, r.w);
	}
}

static void rows3(const glm::mat3 &m)
{
	int i;
	for (i = 0; i < 3; i++) {
		glm::vec3 r = glm::row(m, i);
		printf("  | %7.3f %7.3f %7.3f |\n", r.x, r.y, r.z);
	}
}

int main(void)
{
	const glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
	const glm::vec3 cen(1, 1, 0);
	const glm::vec3 ta(0, -2, 2), tb(2, 2, 2), tc(-2, 2, 2);
	const float rad = 2.0f;

	printf("Q1) pixel in view coordinates\n");
	glm::vec3 p_vcs(-2.0f + 4.0f * 150.5f / 301.0f, -1.0f + 2.0f * 100.5f / 201.0f, -2.0f);
	SHOW3("P_VCS", p_vcs);

	printf("Q2) basis vectors\n");
	glm::vec3 z = glm::normalize(eye - lookat);
	glm::vec3 x = glm::normalize(glm::cross(vup, z));
	glm::vec3 y = glm::cross(z, x);
	SHOW3("X_vcs", x);
	SHOW3("Y_vcs", y);
	SHOW3("Z_vcs", z);

	printf("Q3) M_VCS_to_WCS\n");
	glm::mat4 m = glm::inverse(glm::lookAt(eye, lookat, vup));
	rows4(m);

	printf("Q4) pixel in world coordinates\n");
	glm::vec3 s = glm::vec3(m * glm::vec4(p_vcs, 1.0f));
	SHOW3("P_WCS", s);

	printf("Q5) ray direction\n");
	glm::vec3 v = glm::normalize(s - eye);
	SHOW3("V", v);

	printf("Q6) sphere\n");
	glm::vec3 o = s - cen;
	float a = glm::dot(v, v), b = 2 * glm::dot(o, v), c = glm::dot(o, o) - rad * rad;
	float d = b * b - 4 * a * c;
	float t = (-b - sqrtf(d)) / (2 * a);
	if (t < 0)
		t = (-b + sqrtf(d)) / (2 * a);
	glm::vec3 ps = s + t * v;
	printf("  a: %.3f\n  b: %.3f\n  c: %.3f\n", a, b, c);
	printf("  d: %.3f\n", d);
	printf("  t: %.3f\n", t);
	SHOW3("hit point", ps);

	printf("Q7) sphere normal\n");
	glm::vec3 ns = glm::normalize(ps - cen);
	SHOW3("N", ns);

	printf("Q8) triangle\n");
	glm::mat3 mat(-v, tb - ta, tc - ta);
	glm::vec3 rhs = s - ta;
	glm::vec3 sol = glm::inverse(mat) * rhs;
	glm::vec3 pt = s + sol[0] * v;
	printf("  matrix A:\n");
	rows3(mat);
	SHOW3("right-hand side", rhs);
	printf("  t: %.3f  u: %.3f  v: %.3f\n", sol[0], sol[1], sol[2]);
	SHOW3("hit point", pt);

	printf("Q9) triangle normal\n");
	glm::vec3 nt = glm::normalize(glm::cross(tb - ta, tc - ta));
	SHOW3("N", nt);

	printf("Q10) first hit\n");
	if (sol[0] < t)
		printf("  ray hits triangle first\n");
	else
		printf("  ray hits sphere first\n");
	return 0;
}
