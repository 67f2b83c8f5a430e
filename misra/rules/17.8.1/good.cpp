// Nothing here may be flagged.
template <typename T>
int size(T value);
int size(int value);
