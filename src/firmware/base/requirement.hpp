// SPDX-License-Identifier: Apache-2.0
// Links code to the requirements that it implements: a wrong or retired requirement id does not compile.
#pragma once

namespace canproof {

/// Links code to a requirement: `static_assert(implements<req::AO4_AOUT_002>)` is above the code that implements it.
/// `implements` is true for every type in generated/<part>/requirements.hpp, which the generator writes from the
/// requirements register. `canproof audit` collects these statements.
template <typename Requirement>
constexpr bool implements = Requirement::in_force;

}  // namespace canproof
