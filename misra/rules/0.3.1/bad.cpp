// Each marked line must be put to a person.
float mean(const float one, const float other) {
    return (one + other) / 2.0F;  // flagged
}
int whole(const double value) {
    return static_cast<int>(value);  // flagged
}
