// SPDX-License-Identifier: Apache-2.0
// Repeats the definition of a_first_place.cpp word for word.
namespace places {
inline int twice(const int value) { return 2 * value; }  // flagged
}  // namespace places
