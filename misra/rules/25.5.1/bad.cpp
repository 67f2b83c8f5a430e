// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <clocale>
void native() {
    static_cast<void>(std::setlocale(LC_ALL, ""));  // flagged
}
