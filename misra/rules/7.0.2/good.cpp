// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
bool some(const int count) { return count != 0; }
bool set(const int* const place) { return place != nullptr; }
