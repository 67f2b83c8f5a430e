// Links from code to the register: a wrong or retired requirement id does not compile.
#pragma once

namespace canproof {

/// Stands in `static_assert(implements<req::AO4_AOUT_002>)` above what implements a requirement. It is true for every
/// type that the register's compiler wrote into generated/<part>/requirements.hpp; the audit collects these statements.
template <typename Requirement>
constexpr bool implements = Requirement::in_force;

}  // namespace canproof
