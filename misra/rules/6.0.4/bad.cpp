// Each marked line must be flagged.
namespace own {
int main();  // flagged
}
