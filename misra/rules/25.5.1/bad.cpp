// Each marked line must be flagged.
#include <clocale>
void native() {
    static_cast<void>(std::setlocale(LC_ALL, ""));  // flagged
}
