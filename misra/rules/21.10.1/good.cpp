// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int read(int value);
