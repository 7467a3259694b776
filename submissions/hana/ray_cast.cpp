#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <cmath>
#include <iostream>
#include <sstream>

// All answers are collected first and written at the end.
std::ostringstream answers;

template <typename V>
void answer(const char *name, const V &v) { answers << "\t" << name << ":\t" << glm::to_string(v) << "\n"; }
template <>
void answer<float>(const char *name, const float &v) { answers << "\t" << name << ":\t" << v << "\n"; }

struct Hit { float t; glm::vec3 p, n; };

Hit castSphere(glm::vec3 s, glm::vec3 v, glm::vec3 o, float r)
{
	Hit h;
	glm::vec3 so = s - o;
	float a = glm::dot(v, v);
	float b = 2.0f * glm::dot(v, so);
	float c = glm::dot(so, so) - r * r;
	float d = b * b - 4.0f * a * c;
	h.t = (-b - sqrtf(d)) / (2.0f * a);
	if (h.t <= 0.0f)
		h.t = (-b + sqrtf(d)) / (2.0f * a);
	h.p = s + h.t * v;
	h.n = glm::normalize(h.p - o);
	answers << "Question 6)\n";
	answer("a", a);
	answer("b", b);
	answer("c", c);
	answer("d", d);
	answer("t", h.t);
	answer("P_s", h.p);
	answers << "Question 7)\n";
	answer("N", h.n);
	return h;
}

Hit castTriangle(glm::vec3 s, glm::vec3 v, glm::vec3 a, glm::vec3 b, glm::vec3 c)
{
	Hit h;
	glm::mat3 m(b - a, c - a, -v);
	glm::vec3 rhs = s - a;
	glm::vec3 x = glm::inverse(m) * rhs;
	h.t = x.z;
	h.p = s + h.t * v;
	h.n = glm::normalize(glm::cross(c - a, b - a));
	answers << "Question 8)\n";
	answer("Matrix A (columns u, v, t)", m);
	answer("RHS", rhs);
	answer("t", x.z);
	answer("u", x.x);
	answer("v", x.y);
	answer("P_t", h.p);
	answers << "Question 9)\n";
	answer("N", h.n);
	return h;
}

int main()
{
	glm::vec3 eye(0, 0, 4), lookat(0), vup(0, 1, 0);

	answers << "Question 1)\n";
	glm::vec4 p(-2.0f + 150.0f * 4.0f / 300.0f, -1.0f + 100.0f * 2.0f / 200.0f, -2.0f, 1.0f);
	answer("P_VCS", p);

	answers << "Question 2)\n";
	glm::vec3 z = glm::normalize(eye - lookat), x = glm::normalize(glm::cross(vup, z)), y = glm::cross(z, x);
	answer("X_vcs", x);
	answer("Y_vcs", y);
	answer("Z_vcs", z);

	answers << "Question 3)\n";
	glm::mat4 inv = glm::inverse(glm::lookAt(eye, lookat, vup));
	answer("M_VCS_to_WCS", inv);

	answers << "Question 4)\n";
	glm::vec4 pw = inv * p;
	answer("P_WCS", pw);

	answers << "Question 5)\n";
	glm::vec3 s(pw), v = glm::normalize(s - eye);
	answer("V", v);

	Hit sphere = castSphere(s, v, glm::vec3(1, 1, 0), 2.0f);
	Hit triangle = castTriangle(s, v, glm::vec3(0, -2, 2), glm::vec3(2, 2, 2), glm::vec3(-2, 2, 2));

	answers << "Question 10)\n\t";
	answers << (triangle.t < sphere.t ? "ray hits triangle first\n" : "ray hits sphere first\n");

	std::cout << answers.str();
	return 0;
}
