#include "tests/paths.h"

namespace tests {

std::string source_folder() {
    return RAPIDITY_SOURCE_FOLDER;
}
std::string program() {
    return RAPIDITY_PROGRAM_FILE;
}

} // namespace tests
