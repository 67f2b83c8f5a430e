// SPDX-License-Identifier: Apache-2.0
// Repeats the definition of another file word for word.
namespace places {
inline int twice(const int value) { return 2 * value; }  // flagged
}  // namespace places
