// Each marked line must be flagged.
int area(int width, int height);  // flagged
int area(int height, int width) { return width * height; }
