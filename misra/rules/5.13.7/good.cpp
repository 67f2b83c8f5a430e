// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
const char16_t* name() { return u"ab"; }
