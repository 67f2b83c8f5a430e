// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <clocale>
void native() {
    static_cast<void>(std::setlocale(LC_ALL, ""));  // flagged
}
