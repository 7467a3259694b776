#include <iostream>
#include <string>
#include <cmath>
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/string_cast.hpp>

using std::cout;
using std::endl;

int main()
{
    glm::vec3 eye(0,0,4);
    glm::vec3 lookat(0,0,0);
    glm::vec3 vup(0,1,0);

    // -------------------------------------------------- 1
    cout << "1." << endl;
    glm::vec3 P_VCS( -2 + (150+0.5)/301*4, -1 + (100+0.5)/201*2, -2 );
    cout << "P_VCS: " << glm::to_string( P_VCS ) << endl;

    // -------------------------------------------------- 2
    cout << "2." << endl;
    glm::vec3 Z = glm::normalize( eye - lookat );
    glm::vec3 X = glm::normalize( glm::cross( vup, Z ) );
    glm::vec3 Y = glm::cross( Z, X );
    cout << "X_vcs: " << glm::to_string( X ) << endl;
    cout << "Y_vcs: " << glm::to_string( Y ) << endl;
    cout << "Z_vcs: " << glm::to_string( Z ) << endl;

    // -------------------------------------------------- 3
    cout << "3." << endl;
    glm::mat4 M( X.x, Y.x, Z.x, eye.x,
                 X.y, Y.y, Z.y, eye.y,
                 X.z, Y.z, Z.z, eye.z,
                 0,   0,   0,   1 );
    cout << "M_VCS_to_WCS: " << glm::to_string( M ) << endl;

    // -------------------------------------------------- 4
    cout << "4." << endl;
    glm::vec3 P_WCS = glm::vec3( M * glm::vec4( P_VCS, 1 ) );
    cout << "P_WCS: " << glm::to_string( P_WCS ) << endl;

    // -------------------------------------------------- 5
    cout << "5." << endl;
    glm::vec3 V = glm::normalize( P_WCS - eye );
    cout << "V: " << glm::to_string( V ) << endl;

    // -------------------------------------------------- 6
    cout << "6." << endl;
    glm::vec3 center(1,1,0);
    float R = 2;
    float a = glm::dot( V, V );
    float b = 2 * glm::dot( V, P_WCS - center );
    float c = glm::dot( P_WCS - center, P_WCS - center ) - R*R;
    float d = b*b - 4*a*c;
    cout << "a: " << a << endl;
    cout << "b: " << b << endl;
    cout << "c: " << c << endl;
    cout << "d: " << d << endl;
    float ts = -1;
    glm::vec3 P_s;
    if( d >= 0 ) {
        ts = ( -b - sqrt(d) ) / ( 2*a );
        if( ts < 0 )
            ts = ( -b + sqrt(d) ) / ( 2*a );
    }
    if( ts > 0 ) {
        P_s = P_WCS + ts * V;
        cout << "t: " << ts << endl;
        cout << "hit point: " << glm::to_string( P_s ) << endl;
    } else
        cout << "no positive t, the ray does not hit the sphere" << endl;

    // -------------------------------------------------- 7
    cout << "7." << endl;
    if( ts > 0 )
        cout << "N: " << glm::to_string( glm::normalize( P_s - center ) ) << endl;
    else
        cout << "no hit, no normal" << endl;

    // -------------------------------------------------- 8
    cout << "8." << endl;
    glm::vec3 A(0,-2,2), B(2,2,2), C(-2,2,2);
    glm::mat3 mat( -V, B-A, C-A );
    glm::vec3 rhs = P_WCS - A;
    glm::vec3 x = glm::inverse( mat ) * rhs;
    glm::vec3 P_t = P_WCS + x.x * V;
    cout << "A: " << glm::to_string( mat ) << endl;
    cout << "rhs: " << glm::to_string( rhs ) << endl;
    cout << "t: " << x.x << endl;
    cout << "u: " << x.y << endl;
    cout << "v: " << x.z << endl;
    cout << "hit point: " << glm::to_string( P_t ) << endl;

    // -------------------------------------------------- 9
    cout << "9." << endl;
    cout << "N: " << glm::to_string( glm::normalize( glm::cross( B-A, C-A ) ) ) << endl;

    // -------------------------------------------------- 10
    cout << "10." << endl;
    bool tri = x.x >= 0 && x.y >= 0 && x.z >= 0 && x.y + x.z <= 1;
    if( tri && ( ts < 0 || x.x < ts ) )
        cout << "ray hits triangle first" << endl;
    else if( ts > 0 )
        cout << "ray hits sphere first" << endl;
    else
        cout << "ray hits nothing" << endl;
}
