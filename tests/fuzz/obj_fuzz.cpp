// OBJ files, from their bytes to a picture.
#include "fuzz/fuzz.hpp"

using namespace scanshade;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const TempFolder folder;
    load_and_draw(folder.write("a.obj", std::string(text_of(data, size))));
    return 0;
}
