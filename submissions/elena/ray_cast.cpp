#include <iostream>
#include <glm/glm.hpp>
#include <glm/ext.hpp>
#include <glm/gtx/string_cast.hpp>

// one function per question, the answers kept in globals

glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
glm::vec3 sphereCenter(1, 1, 0);
float sphereRadius = 2;
glm::vec3 triA(0, -2, 2), triB(2, 2, 2), triC(-2, 2, 2);

glm::vec3 pixelVcs, xVcs, yVcs, zVcs, pixelWcs, V, sphereHit, sphereN, triHit, triN;
glm::mat4 M;
float tSphere, tTri;

void question1() {
	float x = -2 + (150 + .5f) * 4 / 301;
	float y = -1 + (100 + .5f) * 2 / 201;
	pixelVcs = glm::vec3(x, y, -2);
	std::cout << "Answer 1: pixel in VCS " << glm::to_string(pixelVcs) << '\n';
}

void question2() {
	zVcs = glm::normalize(eye - lookat);
	xVcs = glm::normalize(glm::cross(vup, zVcs));
	yVcs = glm::cross(zVcs, xVcs);
	std::cout << "Answer 2: X_vcs " << glm::to_string(xVcs) << '\n';
	std::cout << "          Y_vcs " << glm::to_string(yVcs) << '\n';
	std::cout << "          Z_vcs " << glm::to_string(zVcs) << '\n';
}

void question3() {
	M = glm::inverse(glm::lookAt(eye, lookat, vup));
	std::cout << "Answer 3: M_VCS_to_WCS " << glm::to_string(M) << '\n';
}

void question4() {
	pixelWcs = M * glm::vec4(pixelVcs, 1);
	std::cout << "Answer 4: pixel in WCS " << glm::to_string(pixelWcs) << '\n';
}

void question5() {
	V = pixelWcs - eye;
	std::cout << "Answer 5: V " << glm::to_string(V) << '\n';
}

void question6() {
	glm::vec3 w = pixelWcs - sphereCenter;
	float a = glm::dot(V, V), b = 2 * glm::dot(V, w), c = glm::dot(w, w) - sphereRadius * sphereRadius;
	float d = b * b - 4 * a * c;
	tSphere = (-b - glm::sqrt(d)) / (2 * a);
	if (tSphere < 0) tSphere = (-b + glm::sqrt(d)) / (2 * a);
	sphereHit = pixelWcs + tSphere * V;
	std::cout << "Answer 6: a " << a << '\n';
	std::cout << "          b " << b << '\n';
	std::cout << "          c " << c << '\n';
	std::cout << "          d " << d << '\n';
	std::cout << "          t " << tSphere << '\n';
	std::cout << "          hit point " << glm::to_string(sphereHit) << '\n';
}

void question7() {
	sphereN = glm::normalize(sphereHit - sphereCenter);
	std::cout << "Answer 7: N " << glm::to_string(sphereN) << '\n';
}

void question8() {
	glm::mat3 A(-V, triB - triA, triC - triA);
	glm::vec3 rhs = pixelWcs - triA;
	glm::vec3 s = glm::inverse(A) * rhs;
	tTri = s.x;
	triHit = triA + s.y * (triB - triA) + s.z * (triC - triA);
	std::cout << "Answer 8: A " << glm::to_string(A) << '\n';
	std::cout << "          rhs " << glm::to_string(rhs) << '\n';
	std::cout << "          t " << s.x << '\n';
	std::cout << "          u " << s.y << '\n';
	std::cout << "          v " << s.z << '\n';
	std::cout << "          hit point " << glm::to_string(triHit) << '\n';
}

void question9() {
	triN = glm::normalize(glm::cross(triB - triA, triC - triA));
	std::cout << "Answer 9: N " << glm::to_string(triN) << '\n';
}

void question10() {
	std::cout << "Answer 10: " << (tTri < tSphere ? "ray hits triangle first" : "ray hits sphere first") << '\n';
}

int main() {
	question1();
	question2();
	question3();
	question4();
	question5();
	question6();
	question7();
	question8();
	question9();
	question10();
}
