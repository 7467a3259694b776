# The error bounds of CylinderFilter, proven by Gappa; those of the circle's roots are in sphere.g, and the comparison of
# two t's is in first.g. Lines that begin with "#:" quote cylinder.h. The bounds scale with the inputs, so that
# |start| + half = 1 is no restriction; then the way to a cap's plane, half - start, is at most 1.
#:        const double start = ray.origin.y - cylinder.center.y;
#:        const double up = half - start, down = -half - start;
# Half of a subnormal height is off by at most 2^-1075, which 2^-1000 covers. The bound is rounded three times.
way_off = way * r2 - s * r1 * (1 + r2);
#:std::min(std::abs(up), std::abs(down)) > 0x1p-22 * (std::abs(start) + half) + 0x1p-1000
bound = 1b-22 * (1 + r1) * (1 + r3) * (1 + r4);
# Beyond the bound the way is off by at most 2^-29 of what is computed, so by less than 2^-28 of the true way.
way_share = 1 / (1 - share) - 1;
#:        const double top = up / ray.direction.y, bottom = down / ray.direction.y;
t_off = (1 + e) * (1 + r3) - 1;
{ r1 in [-1b-53, 1b-53] /\ r2 in [-1b-53, 1b-53] /\ r3 in [-1b-53, 1b-53] /\ r4 in [-1b-53, 1b-53] /\
  s in [-1, 1] /\ way in [-1, 1] /\ share in [-1b-29, 1b-29] /\ e in [-1b-28, 1b-28]
->
  |way_off| <= 2058b-63 /\ bound * 1b-29 - |way_off| >= 1b-53 /\ |way_share| <= 1b-28 /\ |t_off| <= 1b-27 }
