// SPDX-License-Identifier: Apache-2.0
// Contains a different definition of a name that a_first_definition.cpp defines.
namespace odr {
struct Point {  // flagged
    long across;
};
}  // namespace odr
