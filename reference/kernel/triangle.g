# The error bounds of TriangleFilter, proven by Gappa. Each rounding multiplies by 1 + r with |r| <= u = 2^-53 as long as
# nothing underflows; a product that underflows is off by at most 2^-1075 (n, below). Lines that begin with "#:" quote
# triangle.h. In what is computed each product of three factors is off by the roundings of the differences in it, of its
# two products, and of the sums that it goes through; the sum of the products' sizes is at most that of the norms, which
# Gappa does not see and is taken as given.
#:          normal(cross(p, q)),
#:        const Vec3<double> side = cross(s, d);
#:        const double minus_det = dot(d, triangle.normal);
#:        t_numerator = -(towards * dot(s, triangle.normal));
#:        inside = std::min(std::min(-minus_u, v), det + minus_u - v);
det_off = (1 + r1) * (1 + r2) * (1 + r3) * (1 + r4) * (1 + r5) * (1 + r6) * (1 + r7) - 1;
w_off = (1 + det_off) * (1 + r8) * (1 + r9) - 1;
t_off = (1 + det_off) * (1 + r8) - 1;
# The bound 2^-49 |V| e n: e is the sum of six sizes, each a difference, and of 2^-300; n adds three more sizes and e.
#:        const double unit = 0x1p-49 * e * n;
#:        error = unit * d_norm;
#:        t_error = unit * e;
e_bound = (1 + r1) * (1 + r2) * (1 + r3) * (1 + r4) * (1 + r5) * (1 + r6) * (1 + r7);
n_bound = e_bound * (1 + r1) * (1 + r2) * (1 + r3) * (1 + r4);
error_bound = 1b-49 * e_bound * n_bound * (1 + r1) * (1 + r2) * (1 + r3) * (1 + r4) * (1 + r5) * (1 + r6);
t_error_bound = 1b-49 * e_bound * n_bound * e_bound * (1 + r1) * (1 + r2) * (1 + r3);
# |p| |q| + |s| |q| + |s| |p| <= e n, and |s| |p| |q| <= e² n, with the norms' sizes as variables.
w_norms = (p + q) * (p + q + s) - (p * q + s * q + s * p);
t_norms = (p + q) * (p + q) * (p + q + s) - s * p * q;
# t is known to 2^-27 where T is to 2^-28 and det to 2^-30.
#:        return det > error && std::abs(inside) > error && std::abs(t_numerator) > 0x1p28 * t_error;
ratio_off = (1 + eT) * (1 + r1) / (1 + edet) - 1;
# allow_for_start adds what the start may change, which up to sixteen roundings do not make too small.
#:    const double by = uncertainty * edges * (1 + 0x1p-40);
#:    filter.error += by * PreparedTriangle::norm(direction);
#:    filter.t_error += by * edges;
added = (1 + 1b-40) * (1 + det_off) * (1 + det_off) * (1 + r1) * (1 + r2);
# Underflow in one product of three factors, in units of |V| + n + 1, of which there are six.
under = 6 * (n1 * third + n1 * r1 + n2) * (1 + det_off);
{ r1 in [-1b-53, 1b-53] /\ r2 in [-1b-53, 1b-53] /\ r3 in [-1b-53, 1b-53] /\ r4 in [-1b-53, 1b-53] /\
  r5 in [-1b-53, 1b-53] /\ r6 in [-1b-53, 1b-53] /\ r7 in [-1b-53, 1b-53] /\ r8 in [-1b-53, 1b-53] /\
  r9 in [-1b-53, 1b-53] /\ p in [0, 1b300] /\ q in [0, 1b300] /\ s in [0, 1b300] /\
  eT in [-1b-28, 1b-28] /\ edet in [-1b-30, 1b-30] /\
  n1 in [-1b-1075, 1b-1075] /\ n2 in [-1b-1075, 1b-1075] /\ third in [-1, 1]
->
  |det_off| <= 898b-60 /\ |w_off| <= 1154b-60 /\ |t_off| <= 1026b-60 /\
  error_bound - |w_off| >= 1b-53 /\ t_error_bound - |t_off| >= 1b-53 /\
  added >= 1 /\ w_norms >= 0 /\ t_norms >= 0 /\ |ratio_off| <= 1b-27 /\ |under| <= 1b-1071 }

w_norms -> p * p + q * q + p * q;
t_norms -> (p + q) * (p + q) * (p + q) + s * (p * p + q * q + p * q);
