// SPDX-License-Identifier: Apache-2.0
// Contains a different definition of a name that another file defines.
namespace odr {
struct Point {  // flagged
    long across;
};
}  // namespace odr
