// SPDX-License-Identifier: Apache-2.0
// Contains the first definition; bad_two.cpp has a different definition of the same name.
namespace odr {
struct Point {  // first definition
    int across;
};
}  // namespace odr
int odr_marker();
