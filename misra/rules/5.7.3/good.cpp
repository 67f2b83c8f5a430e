// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file: a path a\b within a comment joins no lines.
int later();
