// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
long long big() { return 1LL; }
