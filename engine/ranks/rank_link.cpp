#include "engine/ranks/rank_link.h"

#include "sim/bad_input.h"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <system_error>

namespace engine {
namespace {

bool started_by_mpirun() {
    // What Open MPI and MPICH tell the processes they start.
    return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMI_SIZE") != nullptr;
}

} // namespace

std::unique_ptr<RankLink> open_rank_link() {
    if (!started_by_mpirun()) {
        return nullptr;
    }
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::filesystem::path library = program.parent_path() / RAPIDITY_MPI_LIBRARY;
    // Never unloaded: MPI keeps threads and handlers of its own until the process ends.
    void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (handle == nullptr) {
        throw sim::BadInput("mpirun", "", "",
                            "this program was built without MPI (libopenmpi-dev), or " + library.string() +
                                " is missing: it runs alone only");
    }
    using Open = RankLink* (*)();
    const auto open = reinterpret_cast<Open>(dlsym(handle, "rapidity_open_rank_link"));
    if (open == nullptr) {
        throw sim::BadInput(library.string(), "", "", "is not the library of this program");
    }
    return std::unique_ptr<RankLink>(open());
}

} // namespace engine
