#include "engine/temporary_folder.h"

#include "engine/failure.h"

#include <cerrno>
#include <cstdlib>
#include <fmt/format.h>
#include <string>
#include <system_error>

namespace engine {

TemporaryFolder::TemporaryFolder() {
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "rapidity-XXXXXX").string();
    if (error || mkdtemp(name.data()) == nullptr) {
        throw Failure(fmt::format("{}: no temporary folder: {}", name,
                                  (error ? error : std::error_code(errno, std::generic_category())).message()));
    }
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

} // namespace engine
