// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file: each name is defined once, and names local to a file do not conflict.
namespace odr {
struct Place {
    int across;
};
struct alignas(8) Pair {
    int first;
};
struct alignas(8) Other {
    int second;
};
namespace {
int hidden(const Place& place) { return place.across; }
}  // namespace
int shown(const Place& place) { return hidden(place); }
}  // namespace odr
