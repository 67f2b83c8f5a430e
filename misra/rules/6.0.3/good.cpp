// Nothing here may be flagged.
namespace own {
int within();
}
int main() { return own::within(); }
