// The items of the assignment under the names that programs give them.
#pragma once

#include "reference/stages/items.h"

namespace student {

inline constexpr reference::ItemId P_VCS = reference::item::P_VCS, X = reference::item::X_vcs,
                                   Y = reference::item::Y_vcs, Z = reference::item::Z_vcs,
                                   M = reference::item::M_VCS_to_WCS, P_WCS = reference::item::P_WCS,
                                   V = reference::item::V;
inline constexpr reference::ItemId a = reference::item::sphere::a, b = reference::item::sphere::b,
                                   c = reference::item::sphere::c, d = reference::item::sphere::d,
                                   t_s = reference::item::sphere::t, hit_s = reference::item::sphere::hit,
                                   normal_s = reference::item::sphere::normal;
inline constexpr reference::ItemId matrix = reference::item::triangle::matrix, rhs = reference::item::triangle::rhs,
                                   t_t = reference::item::triangle::t, u = reference::item::triangle::u,
                                   v = reference::item::triangle::v, hit_t = reference::item::triangle::hit,
                                   normal_t = reference::item::triangle::normal;

}  // namespace student
