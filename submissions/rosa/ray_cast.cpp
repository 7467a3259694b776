#include <iostream>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
using namespace std;
using namespace glm;

int main(){
  vec3 eye=vec3(0,0,4); vec3 lookat=vec3(0,0,0); vec3 vup=vec3(0,1,0);
  vec3 sc=vec3(1,1,0); float sr=2;
  vec3 A=vec3(0,-2,2); vec3 B=vec3(2,2,2); vec3 C=vec3(-2,2,2);

  vec3 pvcs=vec3(-2+4*(150.5/301),-1+2*(100.5/201),-2);
  cout<<"question 1"<<endl;
  cout<<"pixel: "<<to_string(pvcs)<<endl;

  vec3 z=normalize(eye-lookat); vec3 x=normalize(cross(vup,z)); vec3 y=cross(z,x);
  cout<<"question 2"<<endl;
  cout<<"x: "<<to_string(x)<<endl;
  cout<<"y: "<<to_string(y)<<endl;
  cout<<"z: "<<to_string(z)<<endl;

  mat4 M=inverse(lookAt(eye,lookat,vup));
  cout<<"question 3"<<endl;
  cout<<"matrix: "<<to_string(M)<<endl;

  vec3 S=vec3(M*vec4(pvcs,1));
  cout<<"question 4"<<endl;
  cout<<"pixel: "<<to_string(S)<<endl;

  vec3 V=normalize(S-eye);
  cout<<"question 5"<<endl;
  cout<<"v: "<<to_string(V)<<endl;

  float a=dot(V,V); float b=2*dot(V,S-sc); float c=dot(S-sc,S-sc)+sr*sr; float d=b*b-4*a*c;
  float ts=(-b-sqrt(d))/(2*a);
  if(ts<0) ts=(-b+sqrt(d))/(2*a);
  vec3 ps=S+ts*V;
  cout<<"question 6"<<endl;
  cout<<"a: "<<a<<endl;
  cout<<"b: "<<b<<endl;
  cout<<"c: "<<c<<endl;
  cout<<"d: "<<d<<endl;
  cout<<"t: "<<ts<<endl;
  cout<<"hit: "<<to_string(ps)<<endl;

  cout<<"question 7"<<endl;
  cout<<"normal: "<<to_string(normalize(ps-sc))<<endl;

  mat3 m=mat3(-V,B-A,C-A);
  vec3 rhs=S-A;
  vec3 tuv=inverse(m)*rhs;
  cout<<"question 8"<<endl;
  cout<<"matrix: "<<to_string(m)<<endl;
  cout<<"rhs: "<<to_string(rhs)<<endl;
  cout<<"t: "<<tuv.x<<endl;
  cout<<"u: "<<tuv.y<<endl;
  cout<<"v: "<<tuv.z<<endl;
  cout<<"hit: "<<to_string(S+tuv.x*V)<<endl;

  cout<<"question 9"<<endl;
  cout<<"normal: "<<to_string(normalize(cross(B-A,C-A)))<<endl;

  cout<<"question 10"<<endl;
  if(ts<tuv.x) cout<<"ray hits sphere first"<<endl;
  else cout<<"ray hits triangle first"<<endl;
}
