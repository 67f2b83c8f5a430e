// Nothing here may be flagged.
#include <string>
#include <utility>
void take(std::string text);
void first(std::string text) { take(std::move(text)); }
