// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
const char16_t* name() {
    return "a" u"b";  // flagged
}
