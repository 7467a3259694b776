# The error bounds of SphereFilter, proven by Gappa. Each rounding multiplies by 1 + r with |r| <= u = 2^-53 as long as
# nothing underflows; a product that underflows is off by at most 2^-1075 (n, below). Lines that begin with "#:" quote
# sphere.h, and the far root in cylinder.h. The bounds scale with the inputs, so that |d| = 1 and m = |f|² + R² = 1 are no
# restriction: F = |f|² and R² = 1 - F, and by Cauchy's inequality |h| <= 1. Gappa does not see these inequalities between
# several variables, nor that a sum of numbers of one sign is off by no more, relatively, than the worst of them; they are
# taken as given.
#:        a = dot(d, d);
#:        h = dot(d, f);
#:        const double f_squared = dot(f, f);
#:        c = f_squared - R_squared;
#:        D = h * h - a * c;
# r0 is that of f's coordinates, the others those of products, sums and the difference.
a_off = (1 + r1) * (1 + r2) * (1 + r3) - 1;
h_off = (1 + r0) * (1 + r1) * (1 + r2) * (1 + r3) - 1;
F_off = (1 + r0) * (1 + r0) * (1 + r1) * (1 + r2) * (1 + r3) - 1;
c_off = F * F_off - (1 - F) * r4 + (F * (1 + F_off) - (1 - F) * (1 + r4)) * r5;
h_square_off = h_ * (2 * dh + h_ * r6) + dh * (dh + r6 * (2 * h_ + dh));
ac_off = c_ * da + dc + da * dc + (c_ + c_ * da + dc + da * dc) * r7;
D_off = dh2 - dac + (h2 + dh2 - ac - dac) * r8;
# What the filter computes: m * 2^-48, and a m * 2^-48 with two more roundings. All terms of m are positive.
#:        m = f_squared + R_squared + k;
#:        am = (overflow_room * m) * (a + k);
#:std::abs(c) > (margin * 0x1p-48) * m
#:std::abs(D) > (margin * (0x1p-48 / overflow_room)) * am
m_bound = 1b-48 * (1 + F_off) * (1 + r6) * (1 + r7);
am_bound = m_bound * (1 + a_off) * (1 + r8) * (1 + r9);
# The root: where |D| > 2^28 2^-48 am, sD = √D > 2^-10, and c and D are known to 2^-28.
#:        const double q = std::abs(h) + std::sqrt(std::abs(D));
#:        const double far = (std::abs(circle.h) + std::sqrt(std::abs(circle.D))) / circle.a;
#:    static constexpr double margin_for_t = 0x1p28;
q_off = (rh + s * (sqrt(1 + eD) * (1 + r1) - 1)) / (h0 + s);
t_from_outside = (1 + ec) * (1 + r3) / ((1 + eq) * (1 + r2)) - 1;
t_from_inside = (1 + eq) * (1 + r2) * (1 + r3) / (1 + ea) - 1;
# allow_for_start multiplies m by 1 + x (1 + e), where x m 2^-48 is twice what the start may change c by and all that it may
# change D / a by. The roundings of x leave e above 2^-41. The last sum and product lose at most 2^-51 of m, which m_bound and
# am_bound above have to spare.
#:    const double more = 1 + 0x1p48 * (4 * f + 2 * uncertainty) * uncertainty * (1 + 0x1p-40) / filter.m;
e_kept = (1 + 1b-40) * (1 + r1) * (1 + r2) * (1 + r3) * (1 + r4) * (1 + r5) * (1 + r6) * (1 + r7) * (1 + r8) - 1;
more_off = (1 + r8) * (1 + r9) - 1 + x * ((1 + e) * (1 + r8) * (1 + r9) - 1);
# Underflow, in units of a + m + 1, which is at least a, m, 2 |h| and 1.
a_under = (n1 + n2 + n3) * (1 + a_off);
c_under = (n1 + n2 + n3 + n4) * (1 + F_off);
D_under = (2 * hs * u3 + u3 * u3 + n1 + as_ * u4 + cs * u3 + u3 * u4 + n2) * (1 + F_off);
{ r0 in [-1b-53, 1b-53] /\ r1 in [-1b-53, 1b-53] /\ r2 in [-1b-53, 1b-53] /\ r3 in [-1b-53, 1b-53] /\
  r4 in [-1b-53, 1b-53] /\ r5 in [-1b-53, 1b-53] /\ r6 in [-1b-53, 1b-53] /\ r7 in [-1b-53, 1b-53] /\
  r8 in [-1b-53, 1b-53] /\ r9 in [-1b-53, 1b-53] /\
  x in [0, 1b2000] /\ e in [1b-41, 1b-39] /\ F in [0, 1] /\ h_ in [-1, 1] /\ c_ in [-1, 1] /\ h2 in [0, 1] /\ ac in [-1, 1] /\
  dh in [-513b-60, 513b-60] /\ da in [-386b-60, 386b-60] /\ dc in [-898b-60, 898b-60] /\
  dh2 in [-1166b-60, 1166b-60] /\ dac in [-1422b-60, 1422b-60] /\
  rh in [-1b-50, 1b-50] /\ h0 in [0, 1] /\ s in [1b-10, 1] /\ (h0 + s) in [1b-10, 2] /\ s / (h0 + s) in [0, 1] /\
  eD in [-1b-28, 1b-28] /\ ec in [-1b-28, 1b-28] /\ eq in [-130b-36, 130b-36] /\ ea in [-1b-50, 1b-50] /\
  n1 in [-1b-1075, 1b-1075] /\ n2 in [-1b-1075, 1b-1075] /\ n3 in [-1b-1075, 1b-1075] /\ n4 in [-1b-1075, 1b-1075] /\
  u3 in [-1b-1073, 1b-1073] /\ u4 in [-1b-1072, 1b-1072] /\ hs in [-1, 1] /\ as_ in [0, 1] /\ cs in [-1, 1]
->
  |a_off| <= 386b-60 /\ |h_off| <= 513b-60 /\ |c_off| <= 898b-60 /\
  |h_square_off| <= 1166b-60 /\ |ac_off| <= 1422b-60 /\ |D_off| <= 23b-53 /\
  e_kept >= 1b-41 /\ more_off >= -1b-51 /\
  m_bound - |c_off| >= 1b-53 /\ am_bound - |D_off| >= 1b-53 /\
  |q_off| <= 130b-36 /\ |t_from_outside| <= 1b-27 /\ |t_from_inside| <= 1b-27 /\
  |a_under| <= 1b-1073 /\ |c_under| <= 130b-1080 /\ |D_under| <= 1b-1070 }

# (h0 + rh + s √(1 + eD) (1 + r1)) / (h0 + s) = 1 + rh / (h0 + s) + s / (h0 + s) (…)
q_off -> rh / (h0 + s) + s / (h0 + s) * (sqrt(1 + eD) * (1 + r1) - 1);
