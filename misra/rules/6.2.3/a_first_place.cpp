// SPDX-License-Identifier: Apache-2.0
// Contains the first definition; the other file repeats it.
namespace places {
inline int twice(const int value) { return 2 * value; }
}  // namespace places
