// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int eight() { return 0 + 8 + 0x01; }
double small() { return 1.5e-06; }
double half() { return 0.5; }
